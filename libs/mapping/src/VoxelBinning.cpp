// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBinning.h"

#include <algorithm>
#include <numeric>

#include "RadixSort.h"

namespace toss {

namespace {

constexpr double kFixedReach = 65536.0 * (1 << kVoxelKeyBits);
constexpr float kLargestIntensity = 65535.0f;

std::uint32_t fixedIntensity(float intensity) {
  // Written so that NaN and infinities count as 0.
  if (!(intensity > 0.0f) || intensity > 3e38f) return 0;
  return static_cast<std::uint32_t>(std::min(intensity, kLargestIntensity) * 65536.0 + 0.5);
}

int bitWidth(std::uint64_t value) {
  return value == 0 ? 0 : 64 - __builtin_clzll(value);
}

/// A run of bits of a key, and how few bits tell its values apart over a set of keys.
struct KeyField {
  int shift, bits;
  std::uint64_t least = ~std::uint64_t{0}, greatest = 0;

  std::uint64_t of(VoxelKey key) const { return key >> shift & ((std::uint64_t{1} << bits) - 1); }
  void see(VoxelKey key) {
    least = std::min(least, of(key));
    greatest = std::max(greatest, of(key));
  }
  int width() const { return bitWidth(greatest - least); }
};

}  // namespace

std::size_t VoxelBinning::take(const Axis& x, const Axis& y, const Axis& z, double scale,
                               const std::vector<float>& intensity, IndexSpan indices) {
  keys_.resize(indices.count);
  returns_.resize(indices.count);
  const float* const bright = intensity.empty() ? nullptr : intensity.data();
  const auto inside = [](double fixed) { return fixed >= 0.0 && fixed < kFixedReach; };
  std::size_t taken = 0;
  for (const std::int32_t i : indices) {
    const double fx = x.level[i] * scale + x.shift;
    const double fy = y.level[i] * scale + y.shift;
    const double fz = z.level[i] * scale + z.shift;
    if (!inside(fx) || !inside(fy) || !inside(fz)) continue;
    const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy),
               iz = static_cast<std::int64_t>(fz);
    keys_[taken] = voxelKeyFromFirst(static_cast<std::uint32_t>(ix >> 16),
                                     static_cast<std::uint32_t>(iy >> 16),
                                     static_cast<std::uint32_t>(iz >> 16));
    returns_[taken] = {bright ? fixedIntensity(bright[i]) : 0, static_cast<std::uint16_t>(ix),
                       static_cast<std::uint16_t>(iy), static_cast<std::uint16_t>(iz)};
    ++taken;
  }
  keys_.resize(taken);
  returns_.resize(taken);
  return indices.count - taken;
}

int VoxelBinning::sortByVoxel() {
  constexpr int local = 3 * kVoxelLocalBits, block = kVoxelBlockBits;
  KeyField x{local + 2 * block, block}, y{local + block, block}, z{local, block};
  for (const VoxelKey key : keys_) x.see(key), y.see(key), z.see(key);
  const int placeBits = bitWidth(keys_.size());
  const int keyBits = x.width() + y.width() + z.width() + local;
  items_.resize(keys_.size());
  if (keyBits + placeBits > 64) {
    sortByComparison(placeBits);
    return placeBits;
  }
  const int yWidth = y.width(), zWidth = z.width();
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const VoxelKey key = keys_[i];
    std::uint64_t item = x.of(key) - x.least;
    item = item << yWidth | (y.of(key) - y.least);
    item = item << zWidth | (z.of(key) - z.least);
    item = item << local | (key & ((1u << local) - 1));
    items_[i] = item << placeBits | i;
  }
  radixSort(items_, placeBits, keyBits, buffer_);
  return placeBits;
}

void VoxelBinning::sortByComparison(int placeBits) {
  std::iota(items_.begin(), items_.end(), std::uint64_t{0});
  std::stable_sort(items_.begin(), items_.end(),
                   [this](std::uint64_t a, std::uint64_t b) { return keys_[a] < keys_[b]; });
  std::uint64_t rank = 0;
  VoxelKey last = keys_[items_.front()];
  for (std::uint64_t& item : items_) {
    rank += keys_[item] != last;
    last = keys_[item];
    item |= rank << placeBits;
  }
}

void VoxelBinning::sum(std::uint32_t cap, std::vector<VoxelContribution>& result) {
  result.clear();
  if (keys_.empty()) return;
  const int placeBits = sortByVoxel();
  std::uint64_t last = ~items_.front();
  for (const std::uint64_t item : items_) {
    const std::uint64_t place = item & ((std::uint64_t{1} << placeBits) - 1);
    if (item >> placeBits != last >> placeBits) {
      last = item;
      result.emplace_back();
      result.back().key = keys_[place];
    }
    VoxelContribution& sum = result.back();
    if (sum.count == cap) continue;
    const Return& r = returns_[place];
    ++sum.count;
    sum.x += r.x;
    sum.y += r.y;
    sum.z += r.z;
    sum.intensity += r.intensity;
  }
}

}  // namespace toss
