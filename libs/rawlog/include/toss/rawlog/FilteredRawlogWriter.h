// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/pipeline/ScanLabels.h>

#include <filesystem>
#include <memory>

namespace toss {

/// Writes filtered.rawlog scan by scan in constant memory, with stock classes of MRPT only, so that
/// every MRPT program reads it without a plug-in. Each scan becomes three observations of its time
/// stamp: a CObservationRobotPose (map <- robot), and two CObservationPointCloud of
/// CPointsMapXYZI in the sensor frame with the sensor's pose on the robot, LIDAR_STATIC and
/// LIDAR_MOVING, either of which may be empty. Returns that are PointState::Invalid are left out.
/// Of several LiDARs the first has these labels, and the others' end in "_" and their own label.
class FilteredRawlogWriter {
 public:
  /// gz saves about a quarter of the size and makes writing some forty times slower.
  enum class Compression { Plain, Gz };

  /// Throws UserError where the file can not be written; so do the other members.
  explicit FilteredRawlogWriter(const std::filesystem::path& file,
                                Compression compression = Compression::Plain);
  ~FilteredRawlogWriter();

  /// `labels` are those of `scan`: std::logic_error where index or number of points differ.
  void add(const PosedScan& scan, const ScanLabels& labels);
  /// Puts the file in place. To be called once, last; without it nothing is left behind.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
