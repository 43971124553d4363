// SPDX-License-Identifier: BSD-3-Clause
#include "FixedChunk.h"

#include <toss/geometry/ProcessorVariants.h>

#include <algorithm>
#include <cstring>

namespace toss {

namespace {

/// Above the bits of fixed-point coordinates, and of the parts of the words of a VoxelRun.
constexpr int kFixedBits = kVoxelKeyBits + 16, kOwnerShift = 36, kCountShift = 60;

/// Bits of a double around 1.5 * 2^52. Such doubles are whole numbers, and their lower bits are
/// these numbers: adding 1.5 * 2^52 rounds, and unlike a conversion the processor does it for
/// several values at a time.
constexpr double kWhole = 1.5 * 4503599627370496.0;
constexpr std::uint64_t kWholeBits = 0x4338000000000000u;

/// The whole number next to a value of [-0.5, 2^51); larger than that for all other values.
[[gnu::always_inline]] inline std::uint64_t rounded(double value) {
  const double whole = value + kWhole;
  std::uint64_t bits;
  std::memcpy(&bits, &whole, sizeof bits);
  return bits ^ kWholeBits;
}

/// `count` values of a scan from place `begin`: where they are, or gathered in `buffer`.
[[gnu::always_inline]] inline const float* valuesAt(const float* scan, const VoxelReturns& returns,
                                                    std::size_t begin, std::size_t count,
                                                    float* buffer) {
  if (!returns.indices) return scan + begin;
  for (std::size_t i = 0; i < count; ++i) buffer[i] = scan[returns.indices[begin + i]];
  return buffer;
}

/// Fixed-point coordinates: 2^37 and more where they are not finite or no key holds them.
[[gnu::always_inline]] inline void fixAxis(const VoxelReturns::Axis& axis,
                                           const VoxelReturns& returns, std::size_t begin,
                                           std::size_t count, std::uint64_t* fixed) {
  // Rounding half a unit lower is rounding down.
  const double shift = axis.shift - 0.5, scale = returns.scale;
  float buffer[FixedChunk::kMost];
  const float* const value = valuesAt(axis.level, returns, begin, count, buffer);
  for (std::size_t i = 0; i < count; ++i) fixed[i] = rounded(value[i] * scale + shift);
}

/// Within [0, 65535]; 0 where it is not finite. Positive floats are ordered as their bits are, and
/// of whole numbers the processor compares several at a time.
[[gnu::always_inline]] inline float shownIntensity(float intensity) {
  constexpr std::int32_t kInfinity = 0x7f800000, kLargest = 0x477fff00;
  std::int32_t bits;
  std::memcpy(&bits, &intensity, sizeof bits);
  bits = bits < kInfinity ? bits : 0;
  bits = bits > 0 ? bits : 0;
  bits = bits < kLargest ? bits : kLargest;
  std::memcpy(&intensity, &bits, sizeof bits);
  return intensity;
}

[[gnu::always_inline]] inline void fixIntensity(const VoxelReturns& returns, std::size_t begin,
                                                std::size_t count, std::uint64_t* fixed) {
  if (!returns.intensity) return std::fill_n(fixed, count, std::uint64_t{0}), void();
  float buffer[FixedChunk::kMost];
  const float* const value = valuesAt(returns.intensity, returns, begin, count, buffer);
  for (std::size_t i = 0; i < count; ++i) fixed[i] = rounded(shownIntensity(value[i]) * 65536.0);
}

/// Owners above the bits of an intensity; the key of those below 0 is kNoVoxel.
[[gnu::always_inline]] inline void fixOwner(const std::int32_t* owners, std::size_t count,
                                            std::uint64_t* fixed, VoxelKey* key) {
  if (!owners) return std::fill_n(fixed, count, std::uint64_t{0}), void();
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t owner = owners[i];
    fixed[i] = static_cast<std::uint64_t>(owner) << kOwnerShift;
    key[i] |= static_cast<std::uint64_t>(-static_cast<std::int64_t>(owner < 0));
  }
}

}  // namespace

TOSS_ALSO_FOR_AVX2
void FixedChunk::fill(const VoxelReturns& returns, std::size_t begin) {
  count = std::min(kMost, returns.count - begin);
  fixAxis(returns.x, returns, begin, count, x_.data());
  fixAxis(returns.y, returns, begin, count, y_.data());
  fixAxis(returns.z, returns, begin, count, z_.data());
  fixIntensity(returns, begin, count, intensity.data());
  constexpr std::uint64_t kOne = std::uint64_t{1} << kCountShift, kOffset = 0xffff;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t x = x_[i], y = y_[i], z = z_[i];
    all |= x | y | z;
    key[i] = voxelKeyFromFirst(x >> 16, y >> 16, z >> 16);
    countAndOffsets[i] = kOne | (x & kOffset) << 40 | (y & kOffset) << 20 | (z & kOffset);
  }
  fixOwner(returns.owner ? returns.owner + begin : nullptr, count, owner.data(), key.data());
  leftOut = 0;
  if (all >> kFixedBits != 0) dropOutOfReach();
  change[0] = 1;
  for (std::size_t i = 1; i < count; ++i)
    change[i] = (key[i] ^ key[i - 1]) | (owner[i] ^ owner[i - 1]);
}

void FixedChunk::dropOutOfReach() {
  for (std::size_t i = 0; i < count; ++i) {
    if ((x_[i] | y_[i] | z_[i]) >> kFixedBits == 0) continue;
    leftOut += owner[i] >> 63 == 0;
    key[i] = kNoVoxel;
  }
}

}  // namespace toss
