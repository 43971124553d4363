// SPDX-License-Identifier: BSD-3-Clause
#include "OutputStream.h"

#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace toss {

struct OutputStream::Handle {
  std::FILE* plain = nullptr;
  gzFile gz = nullptr;

  ~Handle() {
    if (plain) std::fclose(plain);
    if (gz) gzclose(gz);
  }
};

OutputStream::OutputStream(const std::filesystem::path& file, std::string shownAs, Format format)
    : shownAs_(std::move(shownAs)), handle_(std::make_unique<Handle>()) {
  errno = 0;
  if (format == Format::Gz) {
    handle_->gz = gzopen(file.c_str(), "wb1");
    if (handle_->gz) gzbuffer(handle_->gz, 1u << 18);
  } else {
    handle_->plain = std::fopen(file.c_str(), "wb");
    if (handle_->plain) std::setvbuf(handle_->plain, nullptr, _IOFBF, std::size_t{1} << 18);
  }
  if (!handle_->gz && !handle_->plain) fail(errno);
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
  if (handle_->plain) {
    if (std::fwrite(buffer, 1, count, handle_->plain) != count) fail(errno);
  } else {
    constexpr std::size_t kLargest = std::size_t{1} << 30;
    const char* bytes = static_cast<const char*>(buffer);
    for (std::size_t done = 0; done < count;) {
      const auto step = static_cast<unsigned>(std::min(kLargest, count - done));
      if (gzwrite(handle_->gz, bytes + done, step) != static_cast<int>(step)) fail(errno);
      done += step;
    }
  }
  position_ += count;
  return count;
}

std::uint64_t OutputStream::Seek(std::int64_t offset, TSeekOrigin origin) {
  if (!handle_ || !handle_->plain || origin != sFromBeginning)
    throw std::logic_error("OutputStream: seeking works in plain files, from the beginning");
  if (std::fseek(handle_->plain, static_cast<long>(offset), SEEK_SET) != 0) fail(errno);
  return static_cast<std::uint64_t>(offset);
}

void OutputStream::close() {
  if (!handle_) return;
  errno = 0;
  std::FILE* plain = std::exchange(handle_->plain, nullptr);
  const gzFile gz = std::exchange(handle_->gz, nullptr);
  handle_.reset();
  if (plain && std::fclose(plain) != 0) fail(errno);
  if (gz && gzclose(gz) != Z_OK) fail(errno);
}

std::size_t OutputStream::Read(void*, std::size_t) {
  throw std::logic_error("OutputStream: opened for writing");
}

}  // namespace toss
