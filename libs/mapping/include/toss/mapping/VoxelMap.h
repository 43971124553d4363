// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/ScanPlaces.h>
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

/// Neighbouring returns of one scan and owner that lie in one voxel, summed. Whole numbers only, so
/// that adding and subtracting are exactly inverse and the order of insertions does not show. A
/// scan has many of them, so they are packed into 24 bytes.
struct VoxelRun {
  /// Returns that a run can hold, and the greatest owner.
  static constexpr std::uint64_t kMostReturns = 15, kMostOwner = (1u << 27) - 1;

  VoxelKey key = 0;
  /// From the top: returns counted (4 bits), and the sums of their offsets x, y, z inside the voxel
  /// in 1/65536 of the voxel size (20 bits each).
  std::uint64_t countAndOffsets = 0;
  /// Owner (28 bits) above the sum of intensities (36 bits) in 1/65536 of the unit of the input,
  /// each within [0, 65535] units; values that are not finite count as 0.
  std::uint64_t ownerAndIntensity = 0;

  std::uint64_t count() const { return countAndOffsets >> 60; }
  std::uint64_t x() const { return countAndOffsets >> 40 & 0xfffff; }
  std::uint64_t y() const { return countAndOffsets >> 20 & 0xfffff; }
  std::uint64_t z() const { return countAndOffsets & 0xfffff; }
  std::uint64_t intensity() const { return ownerAndIntensity & ((std::uint64_t{1} << 36) - 1); }
  std::size_t owner() const { return static_cast<std::size_t>(ownerAndIntensity >> 36); }
};

/// Runs in a row, in any order; lent by the caller.
struct RunSpan {
  const VoxelRun *first = nullptr, *last = nullptr;

  RunSpan() = default;
  RunSpan(const VoxelRun* begin, const VoxelRun* end) : first(begin), last(end) {}
  RunSpan(const std::vector<VoxelRun>& all) : first(all.data()), last(first + all.size()) {}

  const VoxelRun* begin() const { return first; }
  const VoxelRun* end() const { return last; }
};

/// What the returns of one scan add to the voxels.
struct BinnedReturns {
  /// Those of owner 0, and those of the others, in order of the scan.
  std::vector<VoxelRun> permanent, owned;
};

/// What one voxel holds: returns, and the sums of their offsets inside the voxel and intensities,
/// all as in VoxelRun.
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
  /// `cap` is within [1, 65535]. Replaces `result`: runs of owner 0, several of which may lie in
  /// one voxel. Returns the number of returns left out because they are not finite or out of reach.
  /// Throws UserError where the sensor itself is. Safe to call from several threads.
  std::size_t bin(const std::vector<float>& x, const std::vector<float>& y,
                  const std::vector<float>& z, const std::vector<float>& intensity,
                  const Eigen::Vector3d& sensorPosition, IndexSpan indices, std::uint32_t cap,
                  std::vector<VoxelRun>& result) const;

  /// The same for all returns of a scan at once, apart by owner: `owner` has shape [n], those below
  /// 0 are passed over, and none is above VoxelRun::kMostOwner. `cap` holds per voxel and owner.
  std::size_t binByOwner(const std::vector<float>& x, const std::vector<float>& y,
                         const std::vector<float>& z, const std::vector<float>& intensity,
                         const Eigen::Vector3d& sensorPosition,
                         const std::vector<std::int32_t>& owner, std::uint32_t cap,
                         BinnedReturns& result) const;

  /// Adds runs, but those of the owners that `without` marks (by owner) where it is given.
  void add(const RunSpan& runs, const std::vector<bool>* without = nullptr);
  /// Takes back what was added. Subtracting what was never added is a logic error and throws.
  void subtract(const RunSpan& runs);
  void subtract(const VoxelSum& sum);

  /// Voxels of the returns of a sensor at `sensorPosition` [m, map frame]. Throws UserError where
  /// that is out of reach.
  ScanPlaces placesOf(const LevelPoints& level, const Eigen::Vector3d& sensorPosition) const;
  /// Whether any voxel holds returns of the cube of 2^bits voxels a side in which `voxel` lies;
  /// `bits` is at most kBlockBits.
  bool holds(VoxelKey voxel, int bits);

  /// Puts tiles into the store that are farther than `radius` [m] from `position` [m, map frame]
  /// and were not needed in the last calls; they come back when they are needed again.
  void leaveBehind(const Eigen::Vector3d& position, double radius);
  /// Tiles that are in the store.
  std::size_t tilesInStore() const;

  /// Voxels that hold at least `minCount` returns.
  std::size_t size(std::uint32_t minCount = 1) const;
  /// Centroid and mean intensity of every such voxel; map frame less `offset` [m]. Block after
  /// block in order of placeInMap(), and by placeInBlock() within.
  std::vector<MapPoint> points(std::uint32_t minCount = 1,
                               const Eigen::Vector3d& offset = Eigen::Vector3d::Zero()) const;
  /// The same one by one, in little more memory than that of one tile.
  void visitPoints(std::uint32_t minCount, const Eigen::Vector3d& offset,
                   const std::function<void(const MapPoint&)>& visit) const;
  double voxelSize() const;
  /// Bytes held, room for growth included.
  std::size_t bytes() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
