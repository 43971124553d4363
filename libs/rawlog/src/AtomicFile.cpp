// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFile.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

namespace toss {
namespace {

std::filesystem::path temporaryFor(const std::filesystem::path& finalPath) {
  // The process number keeps two runs that write the same file apart.
  std::filesystem::path name = finalPath.stem();
  name += ".partial-" + std::to_string(::getpid());
  name += finalPath.extension();
  return finalPath.parent_path() / name;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path finalPath)
    : finalPath_(std::move(finalPath)), temporaryPath_(temporaryFor(finalPath_)) {
  if (finalPath_.filename().empty())
    throw UserError(finalPath_.string(), "is no file name", "give the name of a file to write");
  std::error_code error;
  const std::filesystem::path folder = finalPath_.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
    throw UserError(finalPath_.string(), "its folder does not exist", "create the folder first");
  if (std::filesystem::is_directory(finalPath_, error))
    throw UserError(finalPath_.string(), "is a folder", "give the name of a file to write");
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) std::filesystem::remove(temporaryPath_, ignored);
}

void AtomicFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporaryPath_, finalPath_, error);
  if (error)
    throw UserError(finalPath_.string(), "can't be written (" + error.message() + ")",
                    "check the folder's permissions and the free space");
  committed_ = true;
}

void writeAtomically(const std::filesystem::path& finalPath,
                     const std::function<void(const std::filesystem::path&)>& write) {
  AtomicFile file(finalPath);
  write(file.temporaryPath());
  file.commit();
}

void writeTextAtomically(const std::filesystem::path& finalPath, const std::string& text) {
  writeAtomically(finalPath, [&](const std::filesystem::path& path) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    out.close();
    if (!out)
      throw UserError(finalPath.string(), "can't be written",
                      "check the folder's permissions and the free space");
  });
}

}  // namespace toss
