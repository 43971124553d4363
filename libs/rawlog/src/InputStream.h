// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CStream.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace toss {

/// A file to read, plain or gz (several gz members one after another too). MRPT's own stream loses
/// the end of a gz file that is cut off; this one checks length and checksum while it reads.
class InputStream : public mrpt::io::CStream {
 public:
  /// Throws UserError if the file is missing, a folder, unreadable or of 0 bytes.
  explicit InputStream(const std::filesystem::path& file);
  ~InputStream() override;

  /// Up to `count` bytes; fewer only at the end of what can be read.
  std::size_t Read(void* target, std::size_t count) override;
  /// The next bytes without taking them, at most `count` (<= 4096), fewer at the end.
  std::string_view peek(std::size_t count);
  /// Whether nothing is left that can be read: the end, or where damage begins.
  bool atEnd() { return peek(1).empty(); }
  /// What is wrong with the file where reading stopped; "" if it ended as it should.
  const std::string& damage() const { return damage_; }
  /// The most bytes that can still be delivered; for gz by its best possible compression.
  std::uint64_t mostBytesLeft() const;
  /// Whether the file is gz.
  bool compressed() const { return inflater_ != nullptr; }
  /// Share of the file that has been read, 0 to 1.
  double progress() const;

  /// Bytes delivered so far, after decompression.
  std::uint64_t getPosition() const override { return position_; }
  /// Size of the file [bytes].
  std::uint64_t getTotalBytesCount() const override { return fileSize_; }
  /// Not for writing, and not for seeking: throw std::logic_error.
  std::size_t Write(const void* buffer, std::size_t count) override;
  std::uint64_t Seek(std::int64_t offset, TSeekOrigin origin) override;

 private:
  struct Inflater;
  std::size_t fill(char* target, std::size_t count);
  std::size_t readFile(char* target, std::size_t count);
  std::size_t inflateInto(char* target, std::size_t count);
  bool readCompressed();

  std::filesystem::path file_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> handle_;
  std::unique_ptr<Inflater> inflater_;
  std::uint64_t fileSize_ = 0, fileRead_ = 0, position_ = 0;
  std::vector<char> ahead_;
  std::size_t aheadBegin_ = 0, aheadEnd_ = 0;
  std::string damage_;
};

}  // namespace toss
