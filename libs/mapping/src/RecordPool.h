// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "VoxelRecord.h"

namespace toss {

namespace detail {

/// Records in the arrays of a RecordPool.
constexpr std::array<std::uint32_t, 9> kPoolCapacities = {0, 2, 4, 8, 16, 24, 32, 48, 64};

/// The first of them in which 0 .. 64 records fit.
constexpr std::array<std::uint8_t, 65> kPoolClasses = [] {
  std::array<std::uint8_t, 65> classes{};
  std::uint8_t sizeClass = 0;
  for (std::uint32_t size = 0; size < classes.size(); ++size) {
    if (size > kPoolCapacities[sizeClass]) ++sizeClass;
    classes[size] = sizeClass;
  }
  return classes;
}();

}  // namespace detail

/// Memory of a tile's records: short arrays of few sizes, cut from pages, and used again for others
/// of their size when they are given back. All of it goes at once.
class RecordPool {
 public:
  /// Records in a line of the cache.
  static constexpr std::uint32_t kInLine = 64 / sizeof(VoxelRecord);

  /// Records in the array that holds `size` of them, 0 .. 64.
  static std::uint32_t capacityFor(std::uint32_t size) {
    return detail::kPoolCapacities[classOf(size)];
  }

  /// An array for `size` records, 1 .. 64; what it holds is not said.
  VoxelRecord* take(std::uint32_t size);
  /// Gives back an array that was taken for `size` records, or for as many as fit in it.
  void giveBack(VoxelRecord* records, std::uint32_t size) { keep(records, classOf(size)); }

  std::size_t bytes() const { return bytes_; }

 private:
  static std::size_t classOf(std::uint32_t size) { return detail::kPoolClasses[size]; }
  void keep(VoxelRecord* records, std::size_t sizeClass);
  void newPage();

  /// The first of the arrays that were given back, which name the next in their first bytes.
  std::array<VoxelRecord*, detail::kPoolCapacities.size()> free_{};
  struct alignas(64) Line {
    std::array<VoxelRecord, kInLine> records;
  };
  std::vector<std::unique_ptr<Line[]>> pages_;
  /// What is left of the last page.
  VoxelRecord* rest_ = nullptr;
  std::size_t restCount_ = 0, bytes_ = 0;
};

}  // namespace toss
