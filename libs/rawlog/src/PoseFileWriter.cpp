// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/PoseFile.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "KittiPoses.h"

namespace toss {
namespace {

std::string tumRow(double time, const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d t = pose.translation();
  char row[320];
  std::snprintf(row, sizeof row, "%.7f %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", time, t.x(),
                t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  return row;
}

}  // namespace

void writePoseFile(const std::filesystem::path& file, PoseFileFormat format,
                   const std::vector<double>& times, const std::vector<Eigen::Isometry3d>& poses) {
  if (times.size() != poses.size())
    throw std::logic_error("writePoseFile: times and poses differ in number");
  std::string text;
  for (std::size_t i = 0; i < poses.size(); ++i)
    text += format == PoseFileFormat::Tum ? tumRow(times[i], poses[i]) : kittiRow(poses[i]);
  writeTextAtomically(file, text);
}

}  // namespace toss
