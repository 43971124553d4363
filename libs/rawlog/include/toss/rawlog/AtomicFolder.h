// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace toss {

/// A folder that appears under its name only when it is complete: the folder's AtomicFile. Without
/// commit() the destructor removes what was written.
class AtomicFolder {
 public:
  /// Makes the temporary folder beside the final one. Throws UserError if it can't.
  explicit AtomicFolder(std::filesystem::path finalPath);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporaryPath_; }
  /// Renames to the final path; a folder of that name is replaced. Throws UserError if it can't.
  void commit();

 private:
  std::filesystem::path finalPath_, temporaryPath_;
};

/// Makes a folder that may exist already. Throws UserError if it can't.
void makeFolder(const std::filesystem::path& folder);

}  // namespace toss
