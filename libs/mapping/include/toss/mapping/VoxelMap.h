// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/TileStore.h>
#include <toss/mapping/VoxelKey.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace toss {

/// Indices of returns in their scan, lent by the caller: a whole vector or a part of one.
struct IndexSpan {
  const std::int32_t* data = nullptr;
  std::size_t count = 0;

  IndexSpan() = default;
  IndexSpan(const std::int32_t* first, std::size_t n) : data(first), count(n) {}
  IndexSpan(const std::vector<std::int32_t>& all) : data(all.data()), count(all.size()) {}

  const std::int32_t* begin() const { return data; }
  const std::int32_t* end() const { return data + count; }
};

/// What a set of returns adds to one voxel. Whole numbers only, so that adding and subtracting are
/// exactly inverse and the order of insertions does not show.
struct VoxelContribution {
  VoxelKey key = 0;
  /// Returns counted.
  std::uint32_t count = 0;
  /// Sums of the offsets inside the voxel, in 1/65536 of the voxel size.
  std::uint32_t x = 0, y = 0, z = 0;
  /// Sum of intensities, in 1/65536 of the unit of the input, each within [0, 65535] units; values
  /// that are not finite count as 0.
  std::uint64_t intensity = 0;
};

/// Contributions in a row, by ascending key; lent by the caller.
struct ContributionSpan {
  const VoxelContribution *begin = nullptr, *end = nullptr;
};

/// What the returns of one scan add to the voxels.
struct BinnedReturns {
  /// Those of owner 0, by ascending key.
  std::vector<VoxelContribution> permanent;
  /// Those of the others, by ascending owner, and by ascending key within each.
  std::vector<VoxelContribution> contributions;
  /// Contributions [begin, end) of each owner above 0 that has any, by ascending owner.
  struct Owner {
    std::uint32_t owner;
    std::size_t begin, end;
  };
  std::vector<Owner> owners;
};

/// Contributions to one voxel added up over many scans; members as in VoxelContribution.
struct VoxelSum {
  VoxelKey key = 0;
  std::uint32_t count = 0;
  std::uint64_t x = 0, y = 0, z = 0, intensity = 0;
};

/// One point of a finished map.
struct MapPoint {
  /// Map frame [m].
  float x = 0, y = 0, z = 0;
  /// Mean intensity, unit of the input.
  float intensity = 0;
};

/// Sparse voxel map whose contributions can be taken back bit by bit.
class VoxelMap {
 public:
  /// `voxelSize` [m], greater than 0. `origin`: map coordinates [m] of the corner of voxel 0,0,0;
  /// keys reach 2^20 voxels from it each way. Throws UserError for a size out of range.
  /// `tileSize` [m]: least edge of the cubes in which leaveBehind() puts what is far into `store`,
  /// which outlives the map; 0 or nullptr = everything stays in memory.
  explicit VoxelMap(double voxelSize, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(),
                    double tileSize = 0.0, TileStore* store = nullptr);
  ~VoxelMap();

  /// Bins returns into voxels: level coordinates x, y, z [m] (shape [n]; see LevelPoints) plus
  /// `sensorPosition` [m, map frame], of which `indices` are taken. `intensity`: shape [n] or
  /// empty. At most `cap` returns per voxel and call are counted, the first of `indices` first;
  /// `cap` is within [1, 65535]. Replaces `result`, ordered by key. Returns the number of returns
  /// left out because they are not finite or out of reach. Throws UserError where the sensor itself
  /// is. Safe to call from several threads.
  std::size_t bin(const std::vector<float>& x, const std::vector<float>& y,
                  const std::vector<float>& z, const std::vector<float>& intensity,
                  const Eigen::Vector3d& sensorPosition, IndexSpan indices, std::uint32_t cap,
                  std::vector<VoxelContribution>& result) const;

  /// The same for all returns of a scan at once, apart by owner: `owner` has shape [n], those below
  /// 0 are passed over. `cap` holds per voxel and owner.
  std::size_t binByOwner(const std::vector<float>& x, const std::vector<float>& y,
                         const std::vector<float>& z, const std::vector<float>& intensity,
                         const Eigen::Vector3d& sensorPosition,
                         const std::vector<std::int32_t>& owner, std::uint32_t cap,
                         BinnedReturns& result) const;

  /// Adds contributions, by ascending key: all, or [first, last).
  void add(const std::vector<VoxelContribution>& contributions);
  void add(const VoxelContribution* first, const VoxelContribution* last);
  /// Adds several runs of contributions: faster than one after another.
  void add(const std::vector<ContributionSpan>& spans);
  /// Takes back what was added. Subtracting what was never added is a logic error and throws.
  void subtract(const std::vector<VoxelContribution>& contributions);
  void subtract(const ContributionSpan& span);
  void subtract(const std::vector<VoxelSum>& sums);

  /// Puts tiles into the store that are farther than `radius` [m] from `position` [m, map frame]
  /// and were not needed in the last calls; they come back when they are needed again.
  void leaveBehind(const Eigen::Vector3d& position, double radius);
  /// Tiles that are in the store.
  std::size_t tilesInStore() const;

  /// Voxels that hold at least `minCount` returns.
  std::size_t size(std::uint32_t minCount = 1) const;
  /// Centroid and mean intensity of every such voxel, by ascending key; map frame less `offset`
  /// [m].
  std::vector<MapPoint> points(std::uint32_t minCount = 1,
                               const Eigen::Vector3d& offset = Eigen::Vector3d::Zero()) const;
  /// The same one by one, in little more memory than that of one tile.
  void visitPoints(std::uint32_t minCount, const Eigen::Vector3d& offset,
                   const std::function<void(const MapPoint&)>& visit) const;
  double voxelSize() const;
  /// Bytes held, the table's load and records kept for growth included.
  std::size_t bytes() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
