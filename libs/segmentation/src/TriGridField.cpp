// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/TriGridField.h>

#include <algorithm>

namespace toss {

TriGridField::TriGridField(double extent, double cellSize)
    : side_(std::max(2, static_cast<int>(2.0 * extent / cellSize + 1e-6))),
      cellSize_(static_cast<float>(cellSize)),
      half_(0.5f * static_cast<float>(side_) * cellSize_),
      squaresPerMetre_(1.0f / cellSize_) {
  findNeighbours();
}

std::array<int, 3> TriGridField::verticesOf(int node) const {
  const int square = node / 4, row = square / side_, column = square % side_;
  const auto corner = [&](int r, int c) { return (row + r) * (side_ + 1) + column + c; };
  const int centre = (side_ + 1) * (side_ + 1) + square;
  switch (node % 4) {
    case 0: return {corner(1, 0), corner(1, 1), centre};
    case 1: return {corner(1, 1), corner(0, 1), centre};
    case 2: return {corner(0, 1), corner(0, 0), centre};
    default: return {corner(0, 0), corner(1, 0), centre};
  }
}

Eigen::Vector2f TriGridField::vertexPosition(int vertex) const {
  const int corners = (side_ + 1) * (side_ + 1);
  const bool isCorner = vertex < corners;
  const int width = isCorner ? side_ + 1 : side_;
  const int index = isCorner ? vertex : vertex - corners;
  const float shift = isCorner ? 0.0f : 0.5f;
  return {(static_cast<float>(index / width) + shift) * cellSize_ - half_,
          (static_cast<float>(index % width) + shift) * cellSize_ - half_};
}

int TriGridField::ringOf(int node) const {
  const int square = node / 4;
  const auto away = [this](int index) { return std::abs(2 * index + 1 - side_) / 2; };
  return std::max(away(square / side_), away(square % side_));
}

void TriGridField::findNeighbours() {
  std::vector<std::vector<std::int32_t>> nodesAt(static_cast<std::size_t>(vertices()));
  for (std::int32_t node = 0; node < nodes(); ++node) {
    for (const int vertex : verticesOf(node)) {
      nodesAt[static_cast<std::size_t>(vertex)].push_back(node);
    }
  }
  neighbourBegin_.push_back(0);
  std::vector<std::int32_t> sharing;
  for (std::int32_t node = 0; node < nodes(); ++node) {
    sharing.clear();
    for (const int vertex : verticesOf(node)) {
      const auto& here = nodesAt[static_cast<std::size_t>(vertex)];
      sharing.insert(sharing.end(), here.begin(), here.end());
    }
    std::sort(sharing.begin(), sharing.end());
    sharing.erase(std::unique(sharing.begin(), sharing.end()), sharing.end());
    sharing.erase(std::find(sharing.begin(), sharing.end(), node));
    neighbours_.insert(neighbours_.end(), sharing.begin(), sharing.end());
    neighbourBegin_.push_back(static_cast<std::int32_t>(neighbours_.size()));
  }
}

}  // namespace toss
