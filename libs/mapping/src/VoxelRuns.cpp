// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelRuns.h"

#include <algorithm>
#include <cstring>

namespace toss {

namespace {

/// Returns that are worked on together: their coordinates stay in the first-level cache.
constexpr std::size_t kChunk = 512;
constexpr std::uint64_t kOutOfReach = ~std::uint64_t{0};

struct Chunk {
  std::uint64_t x[kChunk], y[kChunk], z[kChunk], intensity[kChunk];
  /// Voxel index: x, y, z of 21 bits each, or kOutOfReach.
  std::uint64_t voxel[kChunk];
};

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
  float buffer[kChunk];
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
  float buffer[kChunk];
  const float* const value = valuesAt(returns.intensity, returns, begin, count, buffer);
  for (std::size_t i = 0; i < count; ++i) fixed[i] = rounded(shownIntensity(value[i]) * 65536.0);
}

void fixChunk(const VoxelReturns& returns, std::size_t begin, std::size_t count, Chunk& chunk) {
  fixAxis(returns.x, returns, begin, count, chunk.x);
  fixAxis(returns.y, returns, begin, count, chunk.y);
  fixAxis(returns.z, returns, begin, count, chunk.z);
  fixIntensity(returns, begin, count, chunk.intensity);
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t x = chunk.x[i], y = chunk.y[i], z = chunk.z[i];
    all |= x | y | z;
    chunk.voxel[i] = x >> 16 << 2 * kVoxelKeyBits | y >> 16 << kVoxelKeyBits | z >> 16;
  }
  if (all >> (kVoxelKeyBits + 16) == 0) return;
  for (std::size_t i = 0; i < count; ++i)
    if ((chunk.x[i] | chunk.y[i] | chunk.z[i]) >> (kVoxelKeyBits + 16) != 0)
      chunk.voxel[i] = kOutOfReach;
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
  std::uint64_t brick_ = kOutOfReach;
  VoxelKey key_ = 0;
};

/// Sums of returns, two in a word: none of them reaches 2^32 (at most 65535 returns).
struct PackedSums {
  std::uint64_t countAndX = 0, yAndZ = 0, intensity = 0;

  void add(const Chunk& chunk, std::size_t i) {
    constexpr std::uint64_t kOffset = 0xffff;
    countAndX += 1 | (chunk.x[i] & kOffset) << 32;
    yAndZ += (chunk.y[i] & kOffset) | (chunk.z[i] & kOffset) << 32;
    intensity += chunk.intensity[i];
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(countAndX); }
  /// Part by part: a copy through memory of what was just written in other parts would wait.
  void copyTo(VoxelContribution& sum) const {
    sum.count = count();
    sum.x = static_cast<std::uint32_t>(countAndX >> 32);
    sum.y = static_cast<std::uint32_t>(yAndZ);
    sum.z = static_cast<std::uint32_t>(yAndZ >> 32);
    sum.intensity = intensity;
  }
};

/// Puts returns together to runs as they come.
class RunBuilder {
 public:
  RunBuilder(std::uint32_t cap, std::vector<VoxelRun>& runs) : cap_(cap), runs_(runs) {}

  void add(const Chunk& chunk, std::size_t i, std::size_t place, std::uint32_t owner) {
    if (chunk.voxel[i] != voxel_ || owner != owner_) {
      finish();
      voxel_ = chunk.voxel[i];
      owner_ = owner;
      sums_ = PackedSums();
      begin_ = static_cast<std::uint32_t>(place);
    }
    if (sums_.count() == cap_) return;
    end_ = static_cast<std::uint32_t>(place + 1);
    sums_.add(chunk, i);
  }
  void finish() {
    if (voxel_ == kOutOfReach) return;
    VoxelRun& run = runs_.emplace_back(keys_.keyOf(voxel_), owner_);
    sums_.copyTo(run.sum);
    run.begin = begin_;
    run.end = end_;
  }

 private:
  std::uint32_t cap_;
  std::vector<VoxelRun>& runs_;
  KeyMaker keys_;
  std::uint64_t voxel_ = kOutOfReach;
  PackedSums sums_;
  std::uint32_t owner_ = 0, begin_ = 0, end_ = 0;
};

}  // namespace

std::size_t appendRuns(const VoxelReturns& returns, std::size_t begin, std::size_t end,
                       std::uint32_t cap, std::vector<VoxelRun>& runs) {
  Chunk chunk;
  RunBuilder builder(cap, runs);
  std::size_t leftOut = 0;
  for (; begin < end; begin += kChunk) {
    const std::size_t count = std::min(kChunk, end - begin);
    fixChunk(returns, begin, count, chunk);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t owner = returns.owner ? returns.owner[begin + i] : 0;
      if (owner < 0) continue;
      if (chunk.voxel[i] == kOutOfReach)
        ++leftOut;
      else
        builder.add(chunk, i, begin + i, static_cast<std::uint32_t>(owner));
    }
  }
  builder.finish();
  return leftOut;
}

}  // namespace toss
