// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace toss {

struct GroundNode;
class TriGridField;

/// How high ground may lie where none is known: at most as high as if it rose like stairs from
/// where it is known. Crowns mostly stand where no ground is seen under them, but it is known
/// nearby that they begin far above any (measured: half of what was removed from maps of sensors
/// that look up).
class NearbyGround {
 public:
  /// Edge of a square, within which ground counts as level [m].
  static constexpr double kSquare = 4.0;

  /// Takes the ground that `nodes` of `field` know, and carries it on beyond its edges.
  void assign(const TriGridField& field, const std::vector<GroundNode>& nodes);
  /// Takes the ground of squares within `extent` [m] of the sensor and a little beyond from
  /// `heightOf(row, column)`: its height [m, level frame], infinite where it is not known. The
  /// sensor is at the first corner of square (0, 0). Carries it on.
  template <typename HeightOf>
  void assign(double extent, HeightOf&& heightOf) {
    clear(static_cast<float>(extent));
    const auto half = static_cast<std::int64_t>(side_ / 2);
    for (std::size_t s = 0; s < highest_.size(); ++s) {
      if (fixed_[s] != 0) continue;
      highest_[s] = heightOf(static_cast<std::int64_t>(s / side_) - half,
                             static_cast<std::int64_t>(s % side_) - half);
      fixed_[s] = highest_[s] < std::numeric_limits<float>::infinity();
    }
    carryOn();
  }
  /// Calls visit(row, column, height) for each square whose ground is known.
  template <typename Visit>
  void visitKnown(Visit&& visit) const {
    const auto half = static_cast<std::int64_t>(side_ / 2);
    for (std::size_t s = 0; s < highest_.size(); ++s)
      if (fixed_[s] != 0 && highest_[s] < std::numeric_limits<float>::infinity())
        visit(static_cast<std::int64_t>(s / side_) - half,
              static_cast<std::int64_t>(s % side_) - half, highest_[s]);
  }

  /// Greatest height that ground may have at a position [m, level frame]; infinity where nothing is
  /// known about it: without any ground, and farther than 32 m from the field.
  float highest(float x, float y) const {
    const float u = (x + half_) * kSquaresPerMetre, v = (y + half_) * kSquaresPerMetre;
    const auto limit = static_cast<float>(side_);
    if (!(u >= 0.0f && v >= 0.0f && u < limit && v < limit))
      return std::numeric_limits<float>::infinity();
    return highest_[static_cast<std::size_t>(u) * side_ + static_cast<std::size_t>(v)];
  }

 private:
  static constexpr float kSquaresPerMetre = 1.0f / static_cast<float>(kSquare);

  void clear(float extent);
  /// The highest plane in a square is its height.
  void takePlanes(const TriGridField& field, const std::vector<GroundNode>& nodes);
  /// Lowers squares to what ground can have that comes from those before them; `way`: 1 for rows
  /// and columns upwards, -1 for downwards.
  void carryOn(std::ptrdiff_t way);
  void carryOn();

  /// Squares along a side, and half the length of a side [m]; centred on the sensor. Around it runs
  /// a border that stays unknown.
  std::size_t side_ = 0;
  float half_ = 0.0f;
  /// Of each square [m], rows along x; and whether it is more than carried on.
  std::vector<float> highest_;
  std::vector<std::uint8_t> fixed_;
};

}  // namespace toss
