// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// The sums of one voxel in 16 bytes while it holds few returns, as nearly all do; of the others a
/// reference to where they are kept.
class VoxelRecord {
 public:
  /// Returns that a record counts itself.
  static constexpr std::uint32_t kMostReturns = 255;

  VoxelRecord() = default;
  /// Of sums with at most kMostReturns returns.
  explicit VoxelRecord(const VoxelSum& sum)
      : countXy_(std::uint64_t{sum.count} << kCountShift | sum.x << kBits | sum.y),
        zIntensity_(sum.z << kIntensityBits | sum.intensity) {}
  /// A reference to sums kept at `place`.
  static VoxelRecord reference(std::uint64_t place) {
    VoxelRecord record;
    record.countXy_ = kReference | place;
    return record;
  }

  bool isReference() const { return (countXy_ & kReference) != 0; }
  std::size_t place() const { return static_cast<std::size_t>(countXy_ & ~kReference); }

  /// Whether the record itself can count a run too; no reference can.
  bool takes(const VoxelRun& run) const {
    return (countXy_ >> kCountShift) + run.count() <= kMostReturns;
  }
  void add(const VoxelRun& run) {
    countXy_ += run.count() << kCountShift | run.x() << kBits | run.y();
    zIntensity_ += run.z() << kIntensityBits | run.intensity();
  }
  /// Of what is no reference.
  VoxelSum sum(VoxelKey key) const {
    return {key,
            static_cast<std::uint32_t>(countXy_ >> kCountShift),
            countXy_ >> kBits & kOffset,
            countXy_ & kOffset,
            zIntensity_ >> kIntensityBits,
            zIntensity_ & kIntensity};
  }

 private:
  /// Of the sum of an offset, and of intensities: see VoxelRun.
  static constexpr int kBits = 24, kIntensityBits = 40, kCountShift = 2 * kBits;
  static constexpr std::uint64_t kOffset = (std::uint64_t{1} << kBits) - 1,
                                 kIntensity = (std::uint64_t{1} << kIntensityBits) - 1,
                                 kReference = std::uint64_t{1} << 63;

  std::uint64_t countXy_ = 0, zIntensity_ = 0;
};
static_assert(sizeof(VoxelRecord) == 16, "the map's memory is counted in these");

}  // namespace toss
