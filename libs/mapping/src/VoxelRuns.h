// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

#include <array>

namespace toss {

/// Returns of one call as the voxels see them: lends the caller's buffers.
struct VoxelReturns {
  /// Fixed-point coordinate along one axis: level coordinate [m] * scale + shift, in 1/65536 of a
  /// voxel, counted from the first voxel that keys can hold.
  struct Axis {
    const float* level;
    double shift;
  };
  Axis x, y, z;
  /// 65536 / voxel size [1/m].
  double scale;
  /// Shape of the scan, or nullptr: then all count as 0.
  const float* intensity;
  /// Where the returns stand in the scan, or nullptr: one after another.
  const std::int32_t* indices;
  /// Number of returns: places are 0 .. count - 1.
  std::size_t count;
  /// Owner of each place, or nullptr: all have owner 0. Those below 0 are passed over.
  const std::int32_t* owner = nullptr;
};

/// Sums neighbouring returns of a scan that lie in one voxel and have one owner, chunk after chunk:
/// all that one chunk needs stays in the first-level cache. Too large to be made often.
class VoxelRuns {
 public:
  /// Returns of one chunk.
  static constexpr std::size_t kChunk = 512;

  /// The runs of the returns at places [begin, begin + kChunk) as far as there are, of at most
  /// `most` returns each, in order of the scan; valid until the next call.
  RunSpan of(const VoxelReturns& returns, std::size_t begin, std::uint64_t most);
  /// Returns of the calls so far that are in no run because they are not finite or out of reach.
  std::size_t leftOut() const { return leftOut_; }

 private:
  using Words = std::array<std::uint64_t, kChunk>;

  void fix(const VoxelReturns& returns, std::size_t begin, std::size_t count);
  void markOutOfReach(std::size_t count);
  void setOwners(const VoxelReturns& returns, std::size_t begin, std::size_t count);
  std::size_t join(std::size_t count, std::uint64_t most);
  std::size_t makeKeys(std::size_t count);

  /// Fixed-point coordinates.
  Words x_, y_, z_;
  /// Of each return: index of its voxel, x, y, z of 21 bits each, or one that no return has; the
  /// other words as in VoxelRun.
  Words voxel_, countAndOffsets_, ownerAndIntensity_;
  /// Their keys are such indices until makeKeys().
  std::array<VoxelRun, kChunk> runs_;
  std::size_t leftOut_ = 0;
};

}  // namespace toss
