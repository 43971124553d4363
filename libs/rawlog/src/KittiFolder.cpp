// SPDX-License-Identifier: BSD-3-Clause
#include "KittiFolder.h"

#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>

#include <algorithm>
#include <cstdlib>
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
      folder.scans.push_back({std::strtoull(file.stem().c_str(), nullptr, 10), file});
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

fs::path posesFile(const fs::path& folder) {
  const fs::path own = folder / "poses.txt";
  if (fs::exists(own)) return own;
  const fs::path absolute = fs::absolute(folder / ".").lexically_normal().parent_path();
  const fs::path shared =
      absolute.parent_path().parent_path() / "poses" / (absolute.filename().string() + ".txt");
  if (fs::exists(shared)) return shared;
  throw UserError(own.string(), "does not exist",
                  "put the poses of the scans there, one row of 12 numbers per scan");
}

void readPoses(KittiFolder& folder) {
  const fs::path file = posesFile(folder.path);
  folder.poses = readKittiPoses(file);
  const fs::path calibration = folder.path / "calib.txt";
  if (fs::exists(calibration)) {
    const Eigen::Isometry3d cameraFromLidar = readKittiCalibration(calibration);
    for (auto& pose : folder.poses) pose = lidarPose(pose, cameraFromLidar);
  } else {
    folder.warnings.push_back(calibration.string() +
                              ": does not exist, poses.txt is taken for the poses of the LiDAR "
                              "itself (KITTI's are the camera's: they need calib.txt)");
  }
}

void checkPoses(KittiFolder& folder) {
  const std::size_t scans = folder.scans.size(), poses = folder.poses.size();
  const std::uint64_t last = folder.scans.back().number;
  if (last < poses) return;
  const std::string where = posesFile(folder.path).string();
  if (poses == scans || poses <= folder.scans.front().number)
    throw UserError(where,
                    "holds " + std::to_string(poses) + " rows, but the last scan is number " +
                        std::to_string(last) + " and row i belongs to scan number i",
                    "number the scans from 000000.bin on, without gaps");
  folder.warnings.push_back(where + ": holds " + std::to_string(poses) +
                            " rows, scans from number " + std::to_string(poses) +
                            " on have no pose and are skipped");
}

void readTimes(KittiFolder& folder, const InputOptions& options) {
  const fs::path file = folder.path / "times.txt";
  const std::uint64_t last = folder.scans.back().number;
  const std::size_t rows = std::min<std::uint64_t>(last + 1, folder.poses.size());
  if (fs::exists(file)) {
    folder.times = readKittiTimes(file);
    if (folder.times.size() < rows)
      throw UserError(file.string(),
                      "holds " + std::to_string(folder.times.size()) + " times, but " +
                          std::to_string(rows) + " scans need one",
                      "write one time per scan, or remove the file to assume a steady rate");
  } else {
    folder.warnings.push_back(file.string() + ": does not exist, one scan every " +
                              std::to_string(options.scanPeriod) +
                              " s is assumed (input.scan_period)");
    for (std::size_t row = 0; row < rows; ++row)
      folder.times.push_back(static_cast<double>(row) * options.scanPeriod);
  }
  for (double& time : folder.times) time = fromMrptTime(toMrptTime(time));
}

}  // namespace

KittiFolder readKittiFolder(const fs::path& path, const InputOptions& options) try {
  KittiFolder folder;
  folder.path = path;
  listScans(folder);
  checkNumbers(folder);
  readPoses(folder);
  checkPoses(folder);
  readTimes(folder, options);
  return folder;
} catch (const fs::filesystem_error& error) {
  throw UserError(error.path1().string(), "can't be read (" + error.code().message() + ")",
                  "check the permissions");
}

}  // namespace toss
