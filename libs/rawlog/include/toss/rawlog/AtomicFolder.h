// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace toss {

/// Makes a folder that may exist already. Throws UserError if it can't.
void makeFolder(const std::filesystem::path& folder);

/// A folder for what is still to come. The destructor removes it where it was made here and is
/// empty, as after a command that failed, and so the folders above it.
class MadeFolder {
 public:
  /// Makes it, with those above it, unless it is there. Throws UserError if it can't.
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

 private:
  /// Those that were not there, the deepest first.
  std::vector<std::filesystem::path> made_;
};

/// A folder that appears under its name only when it is complete: the folder's AtomicFile. Without
/// commit() the destructor removes what was written.
class AtomicFolder {
 public:
  /// Makes the temporary folder beside the final one, with the folders above it. Throws UserError
  /// if it can't.
  explicit AtomicFolder(std::filesystem::path finalPath);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporaryPath_; }
  /// Renames to the final path; a folder of that name is replaced. Throws UserError if it can't.
  void commit();

 private:
  std::filesystem::path finalPath_, temporaryPath_;
  MadeFolder parent_;
};

}  // namespace toss
