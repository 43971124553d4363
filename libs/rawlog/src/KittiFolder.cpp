// SPDX-License-Identifier: BSD-3-Clause
#include "KittiFolder.h"

#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "KittiPoses.h"

namespace toss {
namespace {

namespace fs = std::filesystem;

bool isNumber(const std::string& text) {
  return !text.empty() && text.size() <= 18 &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

void listScans(KittiFolder& folder) {
  const fs::path velodyne = folder.path / "velodyne";
  if (!fs::is_directory(velodyne))
    throw UserError(folder.path.string(), "has no folder velodyne/ with scans in it",
                    "give the folder of one sequence in KITTI layout, or a .rawlog file");
  std::size_t others = 0;
  for (const auto& entry : fs::directory_iterator(velodyne)) {
    const fs::path& file = entry.path();
    const bool isScan = file.extension() == ".bin" && isNumber(file.stem().string());
    if (isScan)
      folder.scans.push_back({std::strtoull(file.stem().c_str(), nullptr, 10), file, {}, {}});
    else
      ++others;
  }
  if (folder.scans.empty())
    throw UserError(velodyne.string(), "holds no scan", "put scans there, named 000000.bin and on");
  if (others > 0)
    folder.warnings.push_back(velodyne.string() + ": " + std::to_string(others) +
                              " entries are not named like 000000.bin and were left out");
  std::sort(folder.scans.begin(), folder.scans.end(), [](const KittiScan& a, const KittiScan& b) {
    return a.number != b.number ? a.number < b.number : a.file < b.file;
  });
}

void checkNumbers(KittiFolder& folder) {
  std::uint64_t missing = 0;
  for (std::size_t i = 1; i < folder.scans.size(); ++i) {
    const std::uint64_t step = folder.scans[i].number - folder.scans[i - 1].number;
    if (step == 0)
      throw UserError(folder.scans[i].file.string(), "has the number of another scan",
                      "remove one of them");
    missing += step - 1;
  }
  if (missing > 0)
    folder.warnings.push_back((folder.path / "velodyne").string() + ": " + std::to_string(missing) +
                              " numbers between the first and the last scan are missing");
}

void readTimes(const fs::path& file, const InputOptions& options, KittiFolder& folder) {
  const bool exists = fs::exists(file);
  const std::vector<double> times = exists ? readKittiTimes(file) : std::vector<double>();
  for (KittiScan& scan : folder.scans) {
    if (exists && scan.number >= times.size()) continue;
    const double time =
        exists ? times[scan.number] : static_cast<double>(scan.number) * options.scanPeriod;
    scan.time = fromMrptTime(toMrptTime(time));
  }
  if (!exists)
    folder.warnings.push_back(file.string() + ": does not exist, one scan every " +
                              std::to_string(options.scanPeriod) +
                              " s is assumed (input.scan_period)");
}

/// Times may end before the scans do only where poses end too.
void checkTimes(const fs::path& file, bool timesNeeded, const KittiFolder& folder) {
  std::uint64_t timed = 0, needed = 0;
  for (const KittiScan& scan : folder.scans) {
    if (scan.time) timed = scan.number + 1;
    if (scan.pose || timesNeeded) needed = scan.number + 1;
  }
  if (timed < needed)
    throw UserError(file.string(),
                    "holds " + std::to_string(readKittiTimes(file).size()) + " times, but " +
                        std::to_string(needed) + " scans need one",
                    "write one time per scan, or remove the file to assume a steady rate");
}

}  // namespace

KittiFolder readKittiFolder(const fs::path& path, const InputOptions& options) try {
  KittiFolder folder;
  folder.path = path;
  listScans(folder);
  checkNumbers(folder);
  const fs::path times = path / "times.txt";
  readTimes(times, options, folder);
  readKittiFolderPoses(options, folder);
  checkTimes(times, !options.poseFile.empty(), folder);
  return folder;
} catch (const fs::filesystem_error& error) {
  throw UserError(error.path1().string(), "can't be read (" + error.code().message() + ")",
                  "check the permissions");
}

}  // namespace toss
