// SPDX-License-Identifier: BSD-3-Clause
#include "InputStream.h"

#include <toss/geometry/Error.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace toss {
namespace {

constexpr std::size_t kAhead = 4096;
constexpr std::size_t kFileBuffer = std::size_t{1} << 18;

std::uint64_t sizeOf(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw UserError(file.string(), "does not exist", "check the path");
  if (std::filesystem::is_directory(file, error))
    throw UserError(file.string(), "is a folder, not a rawlog", "give the path of a file");
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (error)
    throw UserError(file.string(), "can't be read (" + error.message() + ")", "check the path");
  if (size == 0) throw UserError(file.string(), "is empty (0 bytes)", "copy or record it again");
  return size;
}

}  // namespace

/// State of decompression: zlib's stream and the compressed bytes that wait for it.
struct InputStream::Inflater {
  Inflater() : buffer(kFileBuffer) {
    if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream); }

  z_stream stream{};
  std::vector<unsigned char> buffer;
  bool memberEnded = false;
  /// Members before the present one.
  int membersEnded = 0;
};

InputStream::InputStream(const std::filesystem::path& file)
    : file_(file), handle_(nullptr, &std::fclose), fileSize_(sizeOf(file)), ahead_(kAhead) {
  handle_.reset(std::fopen(file.c_str(), "rb"));
  if (!handle_) throw UserError(file.string(), "can't be opened", "check its permissions");
  std::setvbuf(handle_.get(), nullptr, _IOFBF, kFileBuffer);
  unsigned char magic[2] = {};
  const std::size_t got = std::fread(magic, 1, sizeof magic, handle_.get());
  std::rewind(handle_.get());
  if (got == 2 && magic[0] == 0x1f && magic[1] == 0x8b) inflater_ = std::make_unique<Inflater>();
}

InputStream::~InputStream() = default;

std::size_t InputStream::readFile(char* target, std::size_t count) {
  const std::size_t got = std::fread(target, 1, count, handle_.get());
  fileRead_ += got;
  if (got < count && std::ferror(handle_.get())) damage_ = "the disk reports an error";
  return got;
}

std::size_t InputStream::fill(char* target, std::size_t count) {
  if (!damage_.empty()) return 0;
  return inflater_ ? inflateInto(target, count) : readFile(target, count);
}

bool InputStream::readCompressed() {
  z_stream& z = inflater_->stream;
  if (z.avail_in == 0) {
    z.next_in = inflater_->buffer.data();
    z.avail_in = static_cast<uInt>(
        readFile(reinterpret_cast<char*>(inflater_->buffer.data()), inflater_->buffer.size()));
  }
  if (z.avail_in == 0 && !inflater_->memberEnded && damage_.empty())
    damage_ = "its gz data is cut off";
  if (z.avail_in > 0 && inflater_->memberEnded) {
    inflateReset(&z);
    inflater_->memberEnded = false;
    ++inflater_->membersEnded;
  }
  return z.avail_in > 0;
}

std::size_t InputStream::inflateInto(char* target, std::size_t count) {
  z_stream& z = inflater_->stream;
  std::size_t done = 0;
  while (done < count && readCompressed()) {
    const std::size_t step = std::min(count - done, std::size_t{1} << 30);
    z.next_out = reinterpret_cast<Bytef*>(target + done);
    z.avail_out = static_cast<uInt>(step);
    const int result = inflate(&z, Z_NO_FLUSH);
    done += step - z.avail_out;
    inflater_->memberEnded = result == Z_STREAM_END;
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) {
      const bool afterMember = inflater_->membersEnded > 0 && z.total_out == 0;
      damage_ = afterMember
                    ? "something that is not gz data follows its gz data"
                    : std::string("its gz data is corrupt (") + (z.msg ? z.msg : "bad data") + ")";
      break;
    }
  }
  return done;
}

std::string_view InputStream::peek(std::size_t count) {
  count = std::min(count, kAhead);
  if (aheadEnd_ - aheadBegin_ < count) {
    std::memmove(ahead_.data(), ahead_.data() + aheadBegin_, aheadEnd_ - aheadBegin_);
    aheadEnd_ -= aheadBegin_;
    aheadBegin_ = 0;
    aheadEnd_ += fill(ahead_.data() + aheadEnd_, count - aheadEnd_);
  }
  return {ahead_.data() + aheadBegin_, std::min(count, aheadEnd_ - aheadBegin_)};
}

std::size_t InputStream::Read(void* target, std::size_t count) {
  char* out = static_cast<char*>(target);
  const std::size_t fromAhead = std::min(count, aheadEnd_ - aheadBegin_);
  std::memcpy(out, ahead_.data() + aheadBegin_, fromAhead);
  aheadBegin_ += fromAhead;
  const std::size_t got =
      fromAhead + (fromAhead < count ? fill(out + fromAhead, count - fromAhead) : 0);
  position_ += got;
  return got;
}

std::uint64_t InputStream::mostBytesLeft() const {
  constexpr std::uint64_t kBestCompression = 1032;
  const std::uint64_t unread = fileSize_ - fileRead_;
  const std::uint64_t inflated =
      inflater_ ? (unread + inflater_->stream.avail_in + 1) * kBestCompression : unread;
  return aheadEnd_ - aheadBegin_ + inflated;
}

double InputStream::progress() const {
  const std::uint64_t waiting = inflater_ ? inflater_->stream.avail_in : 0;
  return static_cast<double>(fileRead_ - waiting) / static_cast<double>(fileSize_);
}

std::size_t InputStream::Write(const void*, std::size_t) {
  throw std::logic_error("InputStream: opened for reading");
}

std::uint64_t InputStream::Seek(std::int64_t, TSeekOrigin) {
  throw std::logic_error("InputStream: can't seek");
}

}  // namespace toss
