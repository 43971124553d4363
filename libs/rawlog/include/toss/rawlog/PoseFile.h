// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace toss {

/// How a text file holds poses.
enum class PoseFileFormat {
  Tum,   ///< "time tx ty tz qx qy qz qw" per line [s, m], in any order of time
  Kitti  ///< 12 numbers per line, the upper 3x4 of the pose; line i belongs to scan i
};

/// Poses in a text file, as SLAM systems and odometries leave them: TUM or KITTI, found out by the
/// first line. Blank lines and lines that begin with # are left out; blanks or commas separate.
class PoseFile {
 public:
  /// `maxGap` [s]: a time between two poses of a TUM file has a pose only if both are at most this
  /// far away. Throws UserError naming file and line for anything that is no pose, for a file
  /// without poses, and for two different poses at one time.
  explicit PoseFile(const std::filesystem::path& file, double maxGap = 0.1);
  ~PoseFile();
  PoseFile(PoseFile&&) noexcept;
  PoseFile& operator=(PoseFile&&) noexcept;

  /// Pose of scan `index` (counted from 0), taken at `time` [s]. TUM: by the time, the pose that
  /// stands there for it, else between the two around it, position linear and rotation by SLERP;
  /// KITTI: by the index. None where the file has none. What the pose is of (LiDAR, robot, camera)
  /// no format tells: the caller must know.
  std::optional<Eigen::Isometry3d> at(std::uint64_t index, double time) const;

  PoseFileFormat format() const;
  /// All poses, by ascending time or in the order of the lines.
  const std::vector<Eigen::Isometry3d>& poses() const;
  /// Their times [s] for TUM; empty for KITTI.
  const std::vector<double>& times() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Writes poses so that reading them gives the same translation bit for bit and, for KITTI, the
/// same rotation too (TUM: to 1e-15). `times` [s], `poses`: shape [n] each. The file appears under
/// its name when it is complete. Throws UserError if it can't be written.
void writePoseFile(const std::filesystem::path& file, PoseFileFormat format,
                   const std::vector<double>& times, const std::vector<Eigen::Isometry3d>& poses);

/// camera <- LiDAR of a KITTI folder with calib.txt; the identity for any other input. In KITTI
/// format, poses of such a folder are by custom the camera's: P = Tr * mapFromLidar * Tr^-1.
Eigen::Isometry3d cameraFromLidarOf(const std::filesystem::path& input);

/// The camera's pose from the LiDAR's (map <- LiDAR) as in KITTI's files: P above.
Eigen::Isometry3d cameraPose(const Eigen::Isometry3d& lidarPose,
                             const Eigen::Isometry3d& cameraFromLidar);

}  // namespace toss
