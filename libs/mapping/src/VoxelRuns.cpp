// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelRuns.h"

#include <algorithm>
#include <cstring>

namespace toss {

namespace {

/// Indices that no voxel has.
constexpr std::uint64_t kNoVoxel = ~std::uint64_t{0}, kBeforeFirst = kNoVoxel - 1;
/// Above the bits of fixed-point coordinates, and of the parts of the words of a VoxelRun.
constexpr int kFixedBits = kVoxelKeyBits + 16, kOwnerShift = 36, kCountShift = 60;

/// Bits of a double around 1.5 * 2^52. Such doubles are whole numbers, and their lower bits are
/// these numbers: adding 1.5 * 2^52 rounds, and unlike a conversion the processor does it for
/// several values at a time.
constexpr double kWhole = 1.5 * 4503599627370496.0;
constexpr std::uint64_t kWholeBits = 0x4338000000000000u;

/// The whole number next to a value of [-0.5, 2^51); larger than that for all other values.
std::uint64_t rounded(double value) {
  const double whole = value + kWhole;
  std::uint64_t bits;
  std::memcpy(&bits, &whole, sizeof bits);
  return bits ^ kWholeBits;
}

/// `count` values of a scan from place `begin`: where they are, or gathered in `buffer`.
const float* valuesAt(const float* scan, const VoxelReturns& returns, std::size_t begin,
                      std::size_t count, float* buffer) {
  if (!returns.indices) return scan + begin;
  for (std::size_t i = 0; i < count; ++i) buffer[i] = scan[returns.indices[begin + i]];
  return buffer;
}

/// Fixed-point coordinates: 2^37 and more where they are not finite or no key holds them.
void fixAxis(const VoxelReturns::Axis& axis, const VoxelReturns& returns, std::size_t begin,
             std::size_t count, std::uint64_t* fixed) {
  // Rounding half a unit lower is rounding down.
  const double shift = axis.shift - 0.5, scale = returns.scale;
  float buffer[VoxelRuns::kChunk];
  const float* const value = valuesAt(axis.level, returns, begin, count, buffer);
  for (std::size_t i = 0; i < count; ++i) fixed[i] = rounded(value[i] * scale + shift);
}

/// Within [0, 65535]; 0 where it is not finite. Positive floats are ordered as their bits are, and
/// of whole numbers the processor compares several at a time.
float shownIntensity(float intensity) {
  constexpr std::int32_t kInfinity = 0x7f800000, kLargest = 0x477fff00;
  std::int32_t bits;
  std::memcpy(&bits, &intensity, sizeof bits);
  bits = bits < kInfinity ? bits : 0;
  bits = bits > 0 ? bits : 0;
  bits = bits < kLargest ? bits : kLargest;
  std::memcpy(&intensity, &bits, sizeof bits);
  return intensity;
}

void fixIntensity(const VoxelReturns& returns, std::size_t begin, std::size_t count,
                  std::uint64_t* fixed) {
  if (!returns.intensity) return std::fill_n(fixed, count, std::uint64_t{0}), void();
  float buffer[VoxelRuns::kChunk];
  const float* const value = valuesAt(returns.intensity, returns, begin, count, buffer);
  for (std::size_t i = 0; i < count; ++i) fixed[i] = rounded(shownIntensity(value[i]) * 65536.0);
}

/// Keys of the voxels of a scan one after another, which seldom change their brick.
class KeyMaker {
 public:
  VoxelKey keyOf(std::uint64_t voxel) {
    constexpr std::uint64_t axis = (std::uint64_t{1} << kVoxelKeyBits) - 1,
                            inBrick = kBrickVoxels - 1;
    constexpr std::uint64_t local =
        inBrick << 2 * kVoxelKeyBits | inBrick << kVoxelKeyBits | inBrick;
    const std::uint64_t x = voxel >> 2 * kVoxelKeyBits, y = voxel >> kVoxelKeyBits & axis,
                        z = voxel & axis;
    if ((voxel & ~local) != brick_) {
      brick_ = voxel & ~local;
      key_ = brickKeyFromFirst(x / kBrickVoxels, y / kBrickVoxels, z / kBrickVoxels);
    }
    return key_ | localKey(x, y, z);
  }

 private:
  std::uint64_t brick_ = kNoVoxel;
  VoxelKey key_ = 0;
};

}  // namespace

void VoxelRuns::fix(const VoxelReturns& returns, std::size_t begin, std::size_t count) {
  fixAxis(returns.x, returns, begin, count, x_.data());
  fixAxis(returns.y, returns, begin, count, y_.data());
  fixAxis(returns.z, returns, begin, count, z_.data());
  fixIntensity(returns, begin, count, ownerAndIntensity_.data());
  constexpr std::uint64_t kOne = std::uint64_t{1} << kCountShift, kOffset = 0xffff;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t x = x_[i], y = y_[i], z = z_[i];
    all |= x | y | z;
    voxel_[i] = x >> 16 << 2 * kVoxelKeyBits | y >> 16 << kVoxelKeyBits | z >> 16;
    countAndOffsets_[i] = kOne | (x & kOffset) << 40 | (y & kOffset) << 20 | (z & kOffset);
  }
  if (returns.owner) setOwners(returns, begin, count);
  if (all >> kFixedBits != 0) markOutOfReach(count);
}

void VoxelRuns::setOwners(const VoxelReturns& returns, std::size_t begin, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t owner = returns.owner[begin + i];
    ownerAndIntensity_[i] |= static_cast<std::uint64_t>(owner) << kOwnerShift;
    // All bits where the owner is below 0.
    voxel_[i] |= static_cast<std::uint64_t>(owner >> 63);
  }
}

void VoxelRuns::markOutOfReach(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if ((x_[i] | y_[i] | z_[i]) >> kFixedBits == 0) continue;
    leftOut_ += ownerAndIntensity_[i] >> 63 == 0;
    voxel_[i] = kNoVoxel;
  }
}

std::size_t VoxelRuns::join(std::size_t count, std::uint64_t most) {
  const std::uint64_t full = most << kCountShift;
  VoxelRun run{kBeforeFirst, 0, 0};
  // Whether a return goes on with a run is hard to foresee: the run is written after each return,
  // and what does not go on moves to the next place.
  std::size_t runs = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool sameOwner = (run.ownerAndIntensity ^ ownerAndIntensity_[i]) >> kOwnerShift == 0;
    const bool goesOn = (run.key == voxel_[i]) & sameOwner & (run.countAndOffsets < full);
    const std::uint64_t kept = 0 - std::uint64_t{goesOn};
    constexpr std::uint64_t kIntensity = (std::uint64_t{1} << kOwnerShift) - 1;
    run.key = voxel_[i];
    run.countAndOffsets = (run.countAndOffsets & kept) + countAndOffsets_[i];
    run.ownerAndIntensity = (run.ownerAndIntensity & kept & kIntensity) + ownerAndIntensity_[i];
    runs += !goesOn;
    runs_[runs - 1] = run;
  }
  return runs;
}

std::size_t VoxelRuns::makeKeys(std::size_t count) {
  KeyMaker keys;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (runs_[i].key == kNoVoxel) continue;
    runs_[kept] = runs_[i];
    runs_[kept++].key = keys.keyOf(runs_[i].key);
  }
  return kept;
}

RunSpan VoxelRuns::of(const VoxelReturns& returns, std::size_t begin, std::uint64_t most) {
  const std::size_t count = std::min(kChunk, returns.count - begin);
  fix(returns, begin, count);
  return {runs_.data(), runs_.data() + makeKeys(join(count, most))};
}

}  // namespace toss
