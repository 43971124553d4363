// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>

#include "InputStream.h"

namespace toss {

/// The objects of a rawlog one after another, in constant memory. A CRawlog that was saved as one
/// object is taken apart.
class RawlogReader {
 public:
  /// Throws UserError if the file can't be read or does not begin as a rawlog does.
  explicit RawlogReader(const std::filesystem::path& file);

  /// The next object; nullptr at the end. Throws UserError naming file, object and remedy where the
  /// file is cut off, corrupt, goes on with something else, or holds a class that is not known.
  mrpt::serialization::CSerializable::Ptr next();
  /// "FILE: object N" of the object that next() gave last, N counted from 0 in the file.
  std::string place() const;
  double progress() const { return stream_.progress(); }
  const std::filesystem::path& file() const { return file_; }

 private:
  mrpt::serialization::CSerializable::Ptr readObject();
  std::string nextClassName();
  [[noreturn]] void failInObject(const std::string& className, const std::string& detail);

  std::filesystem::path file_;
  InputStream stream_;
  /// Objects read from the file so far.
  std::uint64_t count_ = 0;
  std::deque<mrpt::serialization::CSerializable::Ptr> unpacked_;
};

}  // namespace toss
