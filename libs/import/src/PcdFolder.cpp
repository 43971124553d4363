// SPDX-License-Identifier: BSD-3-Clause
#include "PcdFolder.h"

#include <toss/geometry/Error.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace toss {
namespace {

/// Greater numbers are times in some unit, not numbers of scans.
constexpr std::uint64_t kGreatestNumber = 99'999'999;

std::optional<std::uint64_t> numberOf(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  std::uint64_t number = 0;
  const char* const end = stem.data() + stem.size();
  const auto [next, error] = std::from_chars(stem.data(), end, number);
  if (error != std::errc() || next != end || number > kGreatestNumber) return std::nullopt;
  return number;
}

std::vector<std::filesystem::path> listPcd(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".pcd" && entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<PcdFolderEntry> pcdFilesIn(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw UserError(folder.string(), "is no folder", "give the folder with the PCD files");
  // The benchmark keeps the true map beside the folder of scans.
  const bool within = std::filesystem::is_directory(folder / "pcd", ignored);
  const std::vector<std::filesystem::path> files = listPcd(within ? folder / "pcd" : folder);
  if (files.empty())
    throw UserError(folder.string(), "holds no PCD files", "give the folder with the PCD files");
  const bool numbered = std::all_of(files.begin(), files.end(),
                                    [](const auto& file) { return numberOf(file).has_value(); });
  std::vector<PcdFolderEntry> entries;
  for (const std::filesystem::path& file : files)
    entries.push_back({file, static_cast<double>(numbered ? *numberOf(file) : entries.size())});
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.place < b.place; });
  const auto twice =
      std::adjacent_find(entries.begin(), entries.end(),
                         [](const auto& a, const auto& b) { return a.place == b.place; });
  if (twice != entries.end())
    throw UserError(twice->file.string(), "has the same number as another file",
                    "name each scan by a number of its own");
  return entries;
}

}  // namespace toss
