// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace toss {

/// Writes a sequence in SemanticKITTI's layout: velodyne/%06d.bin, labels/%06d.label, poses.txt,
/// calib.txt, times.txt. The folder appears under its name only when it is complete: call commit().
class KittiFolderWriter {
 public:
  /// `cameraFromLidar`: Tr of calib.txt; the poses are written as P = Tr * mapFromSensor * Tr^-1.
  /// With the identity, reading gives the same poses bit for bit. Throws UserError if `folder`
  /// exists and is not empty, or can't be made.
  explicit KittiFolderWriter(
      const std::filesystem::path& folder,
      const Eigen::Isometry3d& cameraFromLidar = Eigen::Isometry3d::Identity());
  ~KittiFolderWriter();

  /// Writes all points of the scan in their order; intensity 0 where there is none. Scans are
  /// numbered by the order of writing. Throws UserError if writing fails.
  void write(const PosedScan& scan);
  /// The same with the scan's labels, shape [points].
  void write(const PosedScan& scan, const std::vector<std::uint32_t>& labels);

  /// Scans written so far.
  std::uint64_t scanCount() const;
  /// Writes poses, calibration and times, and gives the folder its name. Throws UserError.
  void commit();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
