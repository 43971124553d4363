// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Segmentation.h>

#include <bitset>
#include <cstdint>
#include <vector>

#include "BoxClaims.h"

namespace toss {

/// Finds returns of the ground layer that touch the foot of an object: feet and tyres lie as low as
/// the ground beside them, and only their nearness to the body tells them apart (spec section 11.1,
/// the loss of feet, tyres and bumpers).
class GroundContact {
 public:
  /// An instance whose foot takes returns, and the claimant that gets them.
  struct Body {
    std::int32_t instance, claimant;
  };

  /// `distance` [m]: largest horizontal reach of a body's lowest half metre, which grows with
  /// range; 0 finds nothing.
  explicit GroundContact(double distance)
      : distance_(static_cast<float>(distance)), inverseDistance_(1.0 / distance) {}

  /// Appends to `claims` every Ground return in reach of a body, by ascending point; the nearest
  /// body wins.
  void find(const LevelPoints& points, const Segmentation& segmentation,
            const std::vector<Body>& bodies, std::vector<BoxClaims::Claim>& claims);

 private:
  static constexpr int kCells = 512;
  /// A return of a body near the ground [m, level frame].
  struct FootPoint {
    float x, y, z;
    std::int32_t claimant, next;
  };
  int cellOf(float coordinate) const;
  void enter(const LevelPoints& points, const Segmentation& segmentation, const Body& body);
  void enterPoint(const FootPoint& point);
  std::int32_t nearest(float x, float y, float z) const;

  float distance_;
  double inverseDistance_;
  std::vector<FootPoint> feet_;
  /// First foot point of each cell, -1 where there is none; cells repeat every kCells, shape
  /// [kCells * kCells].
  std::vector<std::int32_t> head_;
  /// Whether a foot point is in a cell or beside it.
  std::bitset<static_cast<std::size_t>(kCells) * kCells> reached_;
};

}  // namespace toss
