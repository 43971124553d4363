// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/segmentation/Segmentation.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "NearbyReturns.h"

namespace toss {

/// Finds the box that claims a return (spec sections 10.2, 10.3, 10.9 and 10.11): sparse returns,
/// the edges of an object, what has melted into a standing instance that a moving trace passes, and
/// what can not be told from it by this scan alone.
class BoxClaims {
 public:
  /// A box that may claim returns.
  struct Claimant {
    /// Map frame [m].
    Box box;
    /// What it may take besides what is in no instance.
    enum class Takes : std::uint8_t {
      Nothing,  ///< too little is known of its trace
      Cuts,     ///< returns out of standing instances: its trace may turn out to move
      Residue   ///< cuts, and residue: its trace seems to move
    } takes = Takes::Nothing;
    /// Instance whose box it is, 0 = none.
    std::int32_t instance = 0;
  };

  /// Growth of a box to its sides and top [m].
  struct Margins {
    /// For what is claimed outright.
    double claim = 0.0;
    /// For what may be residue of the object; 0 = nothing is.
    double residue = 0.0;
  };

  /// `residueHeight` [m]: ground returns lower than this over the ground are residue at most.
  BoxClaims(const Margins& margins, double residueHeight)
      : margins_(margins), residueHeight_(residueHeight) {}

  /// A return that a box has claimed.
  struct Claim {
    std::int32_t point = 0, claimant = 0;
    /// Standing instance out of which it is taken, 0 = none.
    std::int32_t host = 0;
    /// Not claimed outright: ground that the object stands on, what stands close beside it.
    bool residue = false;
  };

  /// Takes the boxes of a scan. `sensorPosition`: origin of the level frame in the map.
  void take(const std::vector<Claimant>& claimants, const Eigen::Vector3d& sensorPosition);
  /// Marks where returns lie that the boxes may claim.
  void markNearby(NearbyReturns& nearby) const;
  /// Replaces `claims` by those of all returns that were found nearby, by ascending point; the
  /// smallest box wins. `standing`: whether instance k may be cut, shape [instanceCount + 1]; one
  /// that has a box is cut only where another box reaches into that.
  void find(const LevelPoints& points, const Segmentation& segmentation,
            const NearbyReturns& nearby, const std::vector<bool>& standing,
            std::vector<Claim>& claims);

  /// Smallest box that holds the point [m, level frame], leaving out the box of
  /// claimant `except`; -1 = none.
  std::int32_t boxAround(const Eigen::Vector3f& point, std::int32_t except) const;

 private:
  /// Upright box in the level frame, ready to be tested.
  struct Footprint {
    float x, y, cosYaw, sinYaw, halfLength, halfWidth, low, high;
    Claimant::Takes takes;
    std::int32_t instance;
    /// The rectangle along the axes around all that it may claim.
    Eigen::AlignedBox2f claimed;

    /// The rectangle along the axes around it, grown by `margin`.
    Eigen::AlignedBox2f extent(float margin) const;
    /// Whether it holds a point of the level frame, grown by `margin`.
    bool holds(const Eigen::Vector3f& point, float margin) const;
  };
  /// Entry of a grid cell's list of boxes.
  struct Entry {
    std::int32_t box, next;
  };
  /// A square of the ground plane.
  struct Cell {
    /// First entry, -1 = none.
    std::int32_t first = -1;
    /// The most that any box in it takes.
    Claimant::Takes most = Claimant::Takes::Nothing;
  };
  void enter(const Claimant& claimant, std::int32_t number, const Eigen::Vector3d& sensorPosition);
  float reachOf(const Footprint& footprint) const;
  /// Whether another box that takes more than nothing reaches into a box.
  bool isMet(std::size_t number) const;
  /// Smallest box that holds the point when grown by `margin`, of those that take at least `least`.
  std::int32_t claimOf(const Eigen::Vector3f& point, float margin, Claimant::Takes least,
                       std::int32_t except) const;
  std::int32_t residueOf(const Eigen::Vector3f& point) const;
  Claim claimOutside(const Eigen::Vector3f& point, bool low) const;
  Claim claimInside(const Eigen::Vector3f& point, std::int32_t host) const;

  Margins margins_;
  double residueHeight_;
  std::vector<Footprint> footprints_;
  /// Whether instance k may be cut, shape [instanceCount + 1].
  std::vector<bool> cuttable_;
  /// Shape [kCells * kCells].
  std::vector<Cell> grid_;
  std::vector<Entry> entries_;
  /// Cells that have entries.
  std::vector<std::size_t> usedCells_;
};

}  // namespace toss
