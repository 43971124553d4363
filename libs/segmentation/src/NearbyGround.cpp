// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/NearbyGround.h>
#include <toss/segmentation/TriGridField.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
/// Squares around the field, the border included.
constexpr int kMargin = 9;
/// Nothing that people walk on rises more over metres than stairs do (measured: .2 loses people on
/// stairs, and .3 finds hardly more crowns).
constexpr float kSteepest = 0.5f;

}  // namespace

void NearbyGround::assign(const TriGridField& field, const std::vector<GroundNode>& nodes) {
  clear(field.extent());
  takePlanes(field, nodes);
  carryOn();
}

void NearbyGround::carryOn() {
  for (const std::ptrdiff_t way : {1, -1}) carryOn(way);
}

void NearbyGround::clear(float extent) {
  const int squares = static_cast<int>(std::ceil(extent * kSquaresPerMetre)) + kMargin;
  side_ = static_cast<std::size_t>(2 * squares);
  half_ = static_cast<float>(squares) / kSquaresPerMetre;
  highest_.assign(side_ * side_, kUnknown);
  fixed_.assign(side_ * side_, 1);
  for (std::size_t row = 1; row + 1 < side_; ++row)
    std::fill_n(fixed_.begin() + static_cast<std::ptrdiff_t>(row * side_ + 1), side_ - 2,
                std::uint8_t{0});
}

void NearbyGround::takePlanes(const TriGridField& field, const std::vector<GroundNode>& nodes) {
  for (int index = 0; index < field.nodes(); ++index) {
    const GroundNode& node = nodes[static_cast<std::size_t>(index)];
    if (!node.isGround()) continue;
    const Eigen::Vector2f place = field.centroidOf(index);
    const float height = node.planeHeight(place.x(), place.y());
    const auto row = static_cast<std::size_t>((place.x() + half_) * kSquaresPerMetre);
    const auto column = static_cast<std::size_t>((place.y() + half_) * kSquaresPerMetre);
    const std::size_t square = row * side_ + column;
    highest_[square] = fixed_[square] != 0 ? std::max(highest_[square], height) : height;
    fixed_[square] = 1;
  }
}

void NearbyGround::carryOn(std::ptrdiff_t way) {
  const float straight = kSteepest / kSquaresPerMetre, diagonal = std::sqrt(2.0f) * straight;
  const auto side = static_cast<std::ptrdiff_t>(side_), squares = side * side;
  const float* const from = highest_.data();
  for (std::ptrdiff_t s = way > 0 ? 0 : squares - 1; s >= 0 && s < squares; s += way) {
    const auto square = static_cast<std::size_t>(s);
    if (fixed_[square] != 0) continue;
    const float beside = std::min(from[s - way], from[s - way * side]) + straight;
    const float across =
        std::min(from[s - way * (side + 1)], from[s - way * (side - 1)]) + diagonal;
    highest_[square] = std::min({highest_[square], beside, across});
  }
}

}  // namespace toss
