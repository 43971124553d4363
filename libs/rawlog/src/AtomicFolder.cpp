// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFolder.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

namespace toss {
namespace {

std::filesystem::path besides(const std::filesystem::path& folder, const char* kind) {
  std::filesystem::path name = folder.has_filename() ? folder : folder.parent_path();
  name += "." + std::string(kind) + "-" + std::to_string(::getpid());
  return name;
}

}  // namespace

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw UserError(folder.string(), "can't be made (" + error.message() + ")",
                    "check the permissions of the folder it is to be in");
}

MadeFolder::MadeFolder(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (std::filesystem::path each = folder;
       !each.empty() && !std::filesystem::exists(each, ignored); each = each.parent_path())
    made_.push_back(each);
  if (!made_.empty()) makeFolder(folder);
}

MadeFolder::~MadeFolder() {
  std::error_code ignored;
  for (const std::filesystem::path& folder : made_) {
    if (std::filesystem::is_empty(folder, ignored)) std::filesystem::remove(folder, ignored);
  }
}

AtomicFolder::AtomicFolder(std::filesystem::path finalPath)
    : finalPath_(std::move(finalPath)),
      temporaryPath_(besides(finalPath_, "partial")),
      parent_(temporaryPath_.parent_path()) {
  makeFolder(temporaryPath_);
}

AtomicFolder::~AtomicFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(temporaryPath_, ignored);
}

void AtomicFolder::commit() {
  std::error_code error, ignored;
  const std::filesystem::path old = besides(finalPath_, "old");
  std::filesystem::rename(finalPath_, old, ignored);
  std::filesystem::rename(temporaryPath_, finalPath_, error);
  if (error) {
    std::filesystem::rename(old, finalPath_, ignored);
    throw UserError(finalPath_.string(), "can't be written (" + error.message() + ")",
                    "check the folder's permissions and the free space");
  }
  std::filesystem::remove_all(old, ignored);
}

}  // namespace toss
