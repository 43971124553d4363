// SPDX-License-Identifier: BSD-3-Clause
#include "OutputStream.h"

#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "GzBlocks.h"

namespace toss {

struct OutputStream::Handle {
  std::FILE* file = nullptr;
  /// What compresses, nullptr for plain files.
  std::unique_ptr<GzBlocks> gz;

  ~Handle() {
    if (file) std::fclose(file);
  }
};

OutputStream::OutputStream(const std::filesystem::path& file, std::string shownAs, Format format)
    : shownAs_(std::move(shownAs)), handle_(std::make_unique<Handle>()) {
  errno = 0;
  handle_->file = std::fopen(file.c_str(), "wb");
  if (!handle_->file) fail(errno);
  std::setvbuf(handle_->file, nullptr, _IOFBF, std::size_t{1} << 18);
  if (format != Format::Plain)
    handle_->gz = std::make_unique<GzBlocks>(handle_->file, format == Format::Gz ? 1 : 0);
}

OutputStream::~OutputStream() = default;

void OutputStream::fail(int errorNumber) {
  const UserError error(shownAs_,
                        std::string("can not be written: ") +
                            (errorNumber ? std::strerror(errorNumber) : "error while compressing"),
                        "make room there, or choose another folder to write to");
  failure_ = error.what();
  throw error;
}

void OutputStream::writeObject(const mrpt::serialization::CSerializable& object) {
  try {
    mrpt::serialization::archiveFrom(*this).WriteObject(object);
  } catch (const std::exception&) {
    if (failure_.empty()) throw;
    throw UserError(failure_);
  }
}

std::size_t OutputStream::Write(const void* buffer, std::size_t count) {
  if (!handle_) throw std::logic_error("OutputStream: written to after close()");
  // Empty vectors have no address, which fwrite does not take.
  if (count == 0) return 0;
  errno = 0;
  const bool written = handle_->gz ? handle_->gz->write(buffer, count)
                                   : std::fwrite(buffer, 1, count, handle_->file) == count;
  if (!written) fail(errno);
  position_ += count;
  return count;
}

std::uint64_t OutputStream::Seek(std::int64_t offset, TSeekOrigin origin) {
  if (!handle_ || handle_->gz || origin != sFromBeginning)
    throw std::logic_error("OutputStream: seeking works in plain files, from the beginning");
  if (std::fseek(handle_->file, static_cast<long>(offset), SEEK_SET) != 0) fail(errno);
  return static_cast<std::uint64_t>(offset);
}

void OutputStream::close() {
  if (!handle_) return;
  errno = 0;
  const bool finished = !handle_->gz || handle_->gz->finish();
  const int error = errno;
  std::FILE* const file = std::exchange(handle_->file, nullptr);
  handle_.reset();
  if (std::fclose(file) != 0) fail(errno);
  if (!finished) fail(error);
}

std::size_t OutputStream::Read(void*, std::size_t) {
  throw std::logic_error("OutputStream: opened for writing");
}

}  // namespace toss
