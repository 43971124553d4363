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
  int bits = 0;
  for (; value != 0; value >>= 1) ++bits;
  return bits;
}

}  // namespace

std::size_t VoxelBinning::take(const Axis& x, const Axis& y, const Axis& z, double scale,
                               const std::vector<float>& intensity, IndexSpan indices) {
  returns_.resize(indices.count);
  const float* const bright = intensity.empty() ? nullptr : intensity.data();
  std::size_t taken = 0;
  for (const std::int32_t i : indices) {
    const double fixed[3] = {x.level[i] * scale + x.shift, y.level[i] * scale + y.shift,
                             z.level[i] * scale + z.shift};
    Return& r = returns_[taken];
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      inside = inside && fixed[axis] >= 0.0 && fixed[axis] < kFixedReach;
      const auto whole = inside ? static_cast<std::int64_t>(fixed[axis]) : 0;
      r.voxel[axis] = static_cast<std::uint32_t>(whole >> 16);
      r.offset[axis] = static_cast<std::uint16_t>(whole & 0xffff);
    }
    r.intensity = bright ? fixedIntensity(bright[i]) : 0;
    taken += inside;
  }
  returns_.resize(taken);
  return indices.count - taken;
}

int VoxelBinning::Range::bits() const {
  return bitWidth(greatest - least);
}

VoxelBinning::Range VoxelBinning::range(int axis) const {
  Range range{~0u, 0u};
  for (const Return& r : returns_) {
    range.least = std::min(range.least, r.voxel[axis]);
    range.greatest = std::max(range.greatest, r.voxel[axis]);
  }
  return range;
}

void VoxelBinning::sortByVoxel() {
  const Range x = range(0), y = range(1), z = range(2);
  const int placeBits = bitWidth(returns_.size());
  const int keyBits = x.bits() + y.bits() + z.bits();
  if (keyBits + placeBits > 64) return sortByComparison();
  items_.resize(returns_.size());
  for (std::size_t i = 0; i < returns_.size(); ++i) {
    const std::uint32_t* const voxel = returns_[i].voxel;
    std::uint64_t item = voxel[0] - x.least;
    item = item << y.bits() | (voxel[1] - y.least);
    item = item << z.bits() | (voxel[2] - z.least);
    items_[i] = item << placeBits | i;
  }
  radixSort(items_, placeBits, keyBits, buffer_);
  order_.resize(returns_.size());
  const std::uint64_t placeMask = (std::uint64_t{1} << placeBits) - 1;
  std::transform(items_.begin(), items_.end(), order_.begin(), [placeMask](std::uint64_t item) {
    return static_cast<std::uint32_t>(item & placeMask);
  });
}

void VoxelBinning::sortByComparison() {
  order_.resize(returns_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::stable_sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return std::lexicographical_compare(returns_[a].voxel, returns_[a].voxel + 3, returns_[b].voxel,
                                        returns_[b].voxel + 3);
  });
}

void VoxelBinning::sum(std::uint32_t cap, std::vector<VoxelContribution>& result) {
  result.clear();
  if (returns_.empty()) return;
  sortByVoxel();
  const Return* last = nullptr;
  for (const std::uint32_t place : order_) {
    const Return& r = returns_[place];
    if (last == nullptr || !std::equal(r.voxel, r.voxel + 3, last->voxel)) {
      last = &r;
      const auto index = [&r](int axis) {
        return static_cast<std::int32_t>(r.voxel[axis]) - kVoxelReach;
      };
      result.emplace_back();
      result.back().key = voxelKey(index(0), index(1), index(2));
    }
    VoxelContribution& sum = result.back();
    if (sum.count == cap) continue;
    ++sum.count;
    sum.x += r.offset[0];
    sum.y += r.offset[1];
    sum.z += r.offset[2];
    sum.intensity += r.intensity;
  }
}

}  // namespace toss
