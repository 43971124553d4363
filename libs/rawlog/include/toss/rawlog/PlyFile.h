// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace toss {

/// Writes a binary little-endian PLY point by point in constant memory: float x y z intensity, and
/// float track where asked for (spec, outputs of `toss map`). The file appears under its name with
/// finish(); without it nothing is left behind.
class PlyWriter {
 public:
  enum class Layout {
    Points,          ///< x y z intensity
    PointsWithTrack  ///< x y z intensity track
  };

  /// `offset` [m, map frame]: what has to be added to the coordinates written; lets maps far from
  /// the origin keep their precision. Noted as "comment offset X Y Z" unless it is zero.
  /// Throws UserError where the file can not be written; so do the other members.
  PlyWriter(const std::filesystem::path& file, Layout layout,
            const Eigen::Vector3d& offset = Eigen::Vector3d::Zero());
  ~PlyWriter();

  /// `track`: number of the trace, 0 = none; floats hold it exactly up to 2^24. Ignored in
  /// Layout::Points.
  void add(const MapPoint& point, std::uint32_t track = 0);
  /// Points added so far.
  std::uint64_t count() const;
  /// Completes the file, which can be read at temporaryPath() then. Nothing may be added after it.
  void close();
  std::filesystem::path temporaryPath() const;
  /// Closes the file unless that is done, and puts it in place. To be called once, last.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Writes all points to `file` as PlyWriter does.
void writePly(const std::filesystem::path& file, const std::vector<MapPoint>& points,
              const Eigen::Vector3d& offset = Eigen::Vector3d::Zero());

/// Reads a map: PLY (binary, either byte order, or ascii; any order of properties of any number
/// type), PCD (binary, compressed or ascii) or a .metricmap of MRPT; found out from the content.
/// Intensity is taken from intensity, scalar_intensity, reflectance, reflectivity or remission,
/// else 0. Points that are not finite are left out. The VIEWPOINT of a PCD is not applied, as PCL
/// does not (PcdFile.h tells it). Throws UserError naming file and place for anything damaged or of
/// another format.
std::vector<MapPoint> readPointCloudFile(const std::filesystem::path& file);

/// The same, with coordinates relative to `offset` [m, map frame], which is that of the file; where
/// it has none and holds doubles more than 10 km from the origin, the first point, rounded to 1 m.
std::vector<MapPoint> readPointCloudFile(const std::filesystem::path& file,
                                         Eigen::Vector3d& offset);

}  // namespace toss
