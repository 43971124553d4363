// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/PcdImport.h>
#include <toss/rawlog/PcdFile.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace toss {

/// Looks whether the files' coordinates are in the frame that the user says, and whether their
/// poses are any: what goes wrong with such folders most often, and without a word.
class PcdFrameCheck {
 public:
  /// `pose`: map <- sensor.
  void add(const PcdScan& pcd, const Eigen::Isometry3d& pose);
  void appendWarnings(const PcdImportOptions& options, std::vector<std::string>& warnings) const;

 private:
  /// Scans so far from the origin that it shows around what their points lie, by what that is.
  std::uint64_t aroundSensor_ = 0, aroundOrigin_ = 0, scans_ = 0;
  std::optional<Eigen::Isometry3d> firstPose_;
  bool posesDiffer_ = false;
};

}  // namespace toss
