// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/TriGridField.h>

#include <algorithm>

namespace toss {

TriGridField::TriGridField(double extent, double cellSize)
    : TriGridField(std::max(2, static_cast<int>(2.0 * extent / cellSize + 1e-6)),
                   static_cast<float>(cellSize)) {}

TriGridField::TriGridField(int side, float cellSize)
    : side_(side),
      cellSize_(cellSize),
      half_(0.5f * static_cast<float>(side) * cellSize),
      squaresPerMetre_(1.0f / cellSize) {
  placeVertices();
  connectNodes();
  findNeighbours();
}

TriGridField TriGridField::refined(int factor) const {
  return TriGridField(side_ * factor, cellSize_ / static_cast<float>(factor));
}

void TriGridField::placeVertices() {
  for (const float shift : {0.0f, 0.5f}) {
    const int width = shift == 0.0f ? side_ + 1 : side_;
    for (int row = 0; row < width; ++row) {
      for (int column = 0; column < width; ++column) {
        positions_.emplace_back((static_cast<float>(row) + shift) * cellSize_ - half_,
                                (static_cast<float>(column) + shift) * cellSize_ - half_);
      }
    }
  }
}

void TriGridField::connectNodes() {
  const auto corner = [this](int row, int column) { return row * (side_ + 1) + column; };
  int centre = (side_ + 1) * (side_ + 1);
  for (int r = 0; r < side_; ++r) {
    for (int c = 0; c < side_; ++c, ++centre) {
      verticesOf_.push_back({corner(r + 1, c), corner(r + 1, c + 1), centre});
      verticesOf_.push_back({corner(r + 1, c + 1), corner(r, c + 1), centre});
      verticesOf_.push_back({corner(r, c + 1), corner(r, c), centre});
      verticesOf_.push_back({corner(r, c), corner(r + 1, c), centre});
    }
  }
}

Eigen::Vector2f TriGridField::centroidOf(int node) const {
  Eigen::Vector2f sum = Eigen::Vector2f::Zero();
  for (const int vertex : verticesOf(node)) sum += vertexPosition(vertex);
  return sum / 3.0f;
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
