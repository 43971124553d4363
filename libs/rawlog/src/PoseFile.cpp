// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/PoseFile.h>

#include <cmath>

#include "KittiPoses.h"
#include "NumberLines.h"
#include "PoseBuffer.h"

namespace toss {
namespace {

using Ticks = PoseBuffer::Ticks;

constexpr std::size_t kTumColumns = 8;
/// TUM files of some tools hold four decimals: the norm of a rounded quaternion is not quite 1.
constexpr double kMaxNormError = 1e-2;
/// The latest time that is one: the year 2100 in nanoseconds is far beyond it.
constexpr double kLatestTime = 4e9;

Ticks ticksOf(double seconds) {
  return toMrptTime(seconds).time_since_epoch().count();
}

/// The rows of a TUM line: time, position, quaternion (x y z w).
std::pair<double, Eigen::Isometry3d> parseTum(const std::string& line, const std::string& place) {
  const std::vector<double> n = parseNumbers(line);
  if (n.size() != kTumColumns)
    throw UserError(place, "is no pose: 8 numbers are needed",
                    "write time tx ty tz qx qy qz qw per line");
  for (const double value : n)
    if (!std::isfinite(value)) throw UserError(place, "is not finite", "remove the line");
  if (std::abs(n[0]) > kLatestTime)
    throw UserError(place, "its time is no time in seconds", "write UNIX seconds, not nanoseconds");
  const Eigen::Quaterniond rotation(n[7], n[4], n[5], n[6]);
  if (std::abs(rotation.norm() - 1.0) > kMaxNormError)
    throw UserError(place, "its quaternion is not of unit length",
                    "write time tx ty tz qx qy qz qw per line");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() << n[1], n[2], n[3];
  return {n[0], pose};
}

/// The format that the first line looks like. Throws UserError where it is neither.
PoseFileFormat formatOf(const std::filesystem::path& file) {
  std::optional<std::size_t> columns;
  int first = 0;
  forEachLine(file, [&](const std::string& line, int number) {
    if (columns) return;
    columns = parseNumbers(line).size();
    first = number;
  });
  if (!columns)
    throw UserError(file.string(), "holds no pose", "give a file in TUM or KITTI format");
  if (*columns == kTumColumns) return PoseFileFormat::Tum;
  if (*columns == 12) return PoseFileFormat::Kitti;
  throw UserError(lineOf(file, first), "is no pose in TUM (8 numbers) or KITTI format (12 numbers)",
                  "write one pose per line, comments with #");
}

}  // namespace

struct PoseFile::Implementation {
  explicit Implementation(double maxGap) : byTime(std::llround(maxGap * 1e7)) {}

  void readTum(const std::filesystem::path& file) {
    forEachLine(file, [&](const std::string& line, int number) {
      const auto [time, pose] = parseTum(line, lineOf(file, number));
      const auto before = byTime.all().find(ticksOf(time));
      if (before != byTime.all().end() && !before->second.isApprox(pose, 1e-9))
        throw UserError(lineOf(file, number), "has the time of another pose, but another position",
                        "keep one pose per time, written with at least three decimals");
      byTime.add(ticksOf(time), pose);
    });
    for (const auto& [ticks, pose] : byTime.all()) {
      times.push_back(fromMrptTime(mrpt::Clock::time_point(mrpt::Clock::duration(ticks))));
      poses.push_back(pose);
    }
  }

  PoseFileFormat format = PoseFileFormat::Tum;
  PoseBuffer byTime;
  std::vector<double> times;
  std::vector<Eigen::Isometry3d> poses;
};

PoseFile::PoseFile(const std::filesystem::path& file, double maxGap)
    : implementation_(std::make_unique<Implementation>(maxGap)) {
  implementation_->format = formatOf(file);
  if (implementation_->format == PoseFileFormat::Kitti)
    implementation_->poses = readKittiPoses(file);
  else
    implementation_->readTum(file);
}

PoseFile::~PoseFile() = default;
PoseFile::PoseFile(PoseFile&&) noexcept = default;
PoseFile& PoseFile::operator=(PoseFile&&) noexcept = default;

std::optional<Eigen::Isometry3d> PoseFile::at(std::uint64_t index, double time) const {
  if (format() == PoseFileFormat::Tum) return implementation_->byTime.at(ticksOf(time));
  return index < poses().size() ? std::optional(poses()[index]) : std::nullopt;
}

PoseFileFormat PoseFile::format() const {
  return implementation_->format;
}

const std::vector<Eigen::Isometry3d>& PoseFile::poses() const {
  return implementation_->poses;
}

const std::vector<double>& PoseFile::times() const {
  return implementation_->times;
}

}  // namespace toss
