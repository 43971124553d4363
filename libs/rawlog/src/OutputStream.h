// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CStream.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace mrpt::serialization {
class CSerializable;
}

namespace toss {

/// A file to write to, plain or gz. MRPT's own streams lose the errors of a full disk; this one
/// throws a UserError for each, at the latest from close().
class OutputStream : public mrpt::io::CStream {
 public:
  enum class Format {
    Plain,
    /// At the fastest level: a higher one gains little on floats.
    Gz,
    /// gz without compression, for points at the end of a run: they shrink by a quarter, and the
    /// whole run takes a twelfth longer for it.
    GzStored
  };

  /// `file`: where the bytes go. `shownAs`: the name that errors give, for files that are written
  /// under a temporary name.
  OutputStream(const std::filesystem::path& file, std::string shownAs, Format format);
  ~OutputStream() override;

  /// Writes an object of MRPT. To be used rather than an archive: archives turn the UserError of
  /// a full disk into an error of their own.
  void writeObject(const mrpt::serialization::CSerializable& object);
  std::size_t Write(const void* buffer, std::size_t count) override;
  /// Plain files only, from the beginning only; std::logic_error otherwise.
  std::uint64_t Seek(std::int64_t offset, TSeekOrigin origin = sFromBeginning) override;
  /// Writes out what is buffered and closes the file.
  void close();

  /// Not for reading: throws std::logic_error.
  std::size_t Read(void* buffer, std::size_t count) override;
  /// Bytes written so far, before compression.
  std::uint64_t getTotalBytesCount() const override { return position_; }
  std::uint64_t getPosition() const override { return position_; }
  std::string getStreamDescription() const override { return shownAs_; }

 private:
  struct Handle;
  [[noreturn]] void fail(int errorNumber);

  std::string shownAs_;
  std::unique_ptr<Handle> handle_;
  std::uint64_t position_ = 0;
  /// The error that writing ended with, "" = none.
  std::string failure_;
};

}  // namespace toss
