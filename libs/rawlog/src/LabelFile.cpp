// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/LabelFile.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <system_error>

namespace toss {

std::filesystem::path labelPath(const std::filesystem::path& folder, std::uint64_t index) {
  char name[32];
  std::snprintf(name, sizeof name, "%06llu.label", static_cast<unsigned long long>(index));
  return folder / name;
}

std::vector<std::uint32_t> readLabels(const std::filesystem::path& file,
                                      std::size_t expectedCount) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in)
    throw UserError(file.string(), "can't be read", "check that the label file exists");
  if (bytes != expectedCount * sizeof(std::uint32_t))
    throw UserError(file.string(),
                    "holds " + std::to_string(bytes) + " bytes, but its scan of " +
                        std::to_string(expectedCount) + " points needs 4 bytes per point",
                    "take the labels that were made for this scan");
  std::vector<std::uint32_t> labels(expectedCount);
  in.read(reinterpret_cast<char*>(labels.data()), static_cast<std::streamsize>(bytes));
  if (!in) throw UserError(file.string(), "can't be read to its end", "check the disk");
  return labels;
}

void writeLabels(const std::filesystem::path& file, const std::vector<std::uint32_t>& labels) {
  writeAtomically(file, [&](const std::filesystem::path& path) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(labels.data()),
              static_cast<std::streamsize>(labels.size() * sizeof(std::uint32_t)));
    out.close();
    if (!out)
      throw UserError(file.string(), "can't be written",
                      "check the folder's permissions and the free space");
  });
}

}  // namespace toss
