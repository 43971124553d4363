// SPDX-License-Identifier: BSD-3-Clause
#include "RecordPool.h"

#include <algorithm>
#include <cstring>

namespace toss {

VoxelRecord* RecordPool::take(std::uint32_t size) {
  const std::size_t sizeClass = classOf(size);
  if (VoxelRecord* const kept = free_[sizeClass]) {
    std::memcpy(&free_[sizeClass], kept, sizeof kept);
    return kept;
  }
  const std::size_t capacity = detail::kPoolCapacities[sizeClass],
                    count = std::max<std::size_t>(capacity, kInLine);
  if (restCount_ < count) newPage();
  VoxelRecord* const records = rest_;
  // What is left of a line stays for others of the size: no array lies across more than it must.
  if (capacity < count) keep(rest_ + capacity, sizeClass);
  rest_ += count;
  restCount_ -= count;
  return records;
}

void RecordPool::keep(VoxelRecord* records, std::size_t sizeClass) {
  std::memcpy(static_cast<void*>(records), &free_[sizeClass], sizeof records);
  free_[sizeClass] = records;
}

void RecordPool::newPage() {
  // A tile of few voxels takes little, and one of many does not ask often.
  constexpr std::size_t kFirst = 32, kLargest = 1024;
  for (std::size_t sizeClass = detail::kPoolCapacities.size() - 1; sizeClass > 0; --sizeClass)
    for (const std::size_t count = detail::kPoolCapacities[sizeClass]; restCount_ >= count;) {
      keep(rest_, sizeClass);
      rest_ += count;
      restCount_ -= count;
    }
  const std::size_t lines = std::clamp(bytes_ / sizeof(Line) / 4, kFirst, kLargest);
  pages_.emplace_back(new Line[lines]);
  rest_ = pages_.back()[0].records.data();
  restCount_ = lines * kInLine;
  bytes_ += lines * sizeof(Line);
}

}  // namespace toss
