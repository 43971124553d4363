// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace toss {

/// Labels in SemanticKITTI's layout: one uint32 per point, low 16 bits class, high 16 instance.
namespace label {
constexpr std::uint32_t kInvalid = 0;   ///< no valid return, or not annotated
constexpr std::uint32_t kStatic = 9;    ///< written for static points
constexpr std::uint32_t kMoving = 251;  ///< written for moving points
constexpr std::uint32_t kFirstMoving = 252, kLastMoving = 259;  ///< moving classes of the benchmark

constexpr std::uint32_t semantic(std::uint32_t value) {
  return value & 0xFFFFu;
}
constexpr std::uint32_t instance(std::uint32_t value) {
  return value >> 16;
}
constexpr bool isMoving(std::uint32_t value) {
  return semantic(value) >= kMoving && semantic(value) <= kLastMoving;
}
}  // namespace label

/// Path of the label file of scan `index`: FOLDER/%06d.label.
std::filesystem::path labelPath(const std::filesystem::path& folder, std::uint64_t index);

/// Throws UserError if the file is missing, is no multiple of 4 bytes, or holds another number of
/// labels than `expectedCount`.
std::vector<std::uint32_t> readLabels(const std::filesystem::path& file, std::size_t expectedCount);

/// Written under a temporary name and renamed when complete; the folder must exist. Throws
/// UserError if it can't be written.
void writeLabels(const std::filesystem::path& file, const std::vector<std::uint32_t>& labels);

}  // namespace toss
