// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace toss {

/// A file that appears under its name only when it is complete: write to temporaryPath(), then
/// commit(). Without commit() the destructor removes what was written.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path finalPath);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// In the same folder and with the same extension as the final path.
  const std::filesystem::path& temporaryPath() const { return temporaryPath_; }
  /// What errors show.
  const std::filesystem::path& finalPath() const { return finalPath_; }
  /// Renames to the final path. Throws UserError if that fails.
  void commit();

 private:
  std::filesystem::path finalPath_, temporaryPath_;
  bool committed_ = false;
};

/// Calls `write` with the temporary path, then commits.
void writeAtomically(const std::filesystem::path& finalPath,
                     const std::function<void(const std::filesystem::path&)>& write);

/// The same for a whole text. Throws UserError where it can not be written, a full disk included.
void writeTextAtomically(const std::filesystem::path& finalPath, const std::string& text);

}  // namespace toss
