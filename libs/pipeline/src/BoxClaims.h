// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/segmentation/Segmentation.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "ClaimBatch.h"
#include "ClaimFootprint.h"
#include "ClaimSquares.h"

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
      : margins_{static_cast<float>(margins.claim), static_cast<float>(margins.residue)},
        residueHeight_(static_cast<float>(residueHeight)) {}

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

  /// Claims of a scan, by ascending point; valid until the next are found.
  struct Claims {
    const Claim *first, *last;
    /// How many of them are residue.
    std::size_t residueCount;
    const Claim* begin() const { return first; }
    const Claim* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };
  /// Finds the claims of the boxes on all returns; the smallest box wins. `standing`: whether
  /// instance k may be cut, shape [instanceCount + 1]; one that has a box is cut only where another
  /// box reaches into that.
  Claims find(const LevelPoints& points, const Segmentation& segmentation,
              const std::vector<bool>& standing);

  /// Smallest box that holds the point [m, level frame], leaving out the box of
  /// claimant `except`; -1 = none.
  std::int32_t boxAround(const Eigen::Vector3f& point, std::int32_t except) const;

 private:
  /// What a box takes, and the rectangle along the axes around all that it may claim.
  struct Terms {
    Claimant::Takes takes;
    std::int32_t instance;
    Eigen::AlignedBox2f claimed;
  };
  /// Entry of a grid cell's list of boxes.
  struct Entry {
    std::int32_t box, next;
  };

  void enter(const Claimant& claimant, std::int32_t number);
  float reachOf(Claimant::Takes takes) const;
  bool claimsResidue(Claimant::Takes takes) const {
    return takes == Claimant::Takes::Residue && margins_.residue != 0.0f;
  }
  /// Whether another box that takes more than nothing reaches into a box.
  bool isMet(std::size_t number) const;
  /// Finds the returns that any box may claim.
  void findNearby(const LevelPoints& points, const Segmentation& segmentation,
                  const std::vector<bool>& standing);
  /// Asks the boxes of each cell about the returns found in it.
  void askBoxes();
  void takeClaims(const Segmentation& segmentation);

  /// Growth of boxes to their sides and top [m].
  struct {
    float claim, residue;
  } margins_;
  float residueHeight_;
  /// Of each claimant.
  std::vector<ClaimFootprint> footprints_;
  std::vector<Terms> terms_;
  std::vector<ClaimBox> boxes_;
  /// Instance of each claimant, after that of claimant -1.
  std::vector<std::int32_t> instanceOf_;
  /// Claimants, those with the largest boxes first.
  std::vector<std::pair<double, std::int32_t>> byVolume_;
  /// Whether instance k may be cut, shape [instanceCount + 1].
  std::vector<bool> cuttable_;
  /// First entry of each cell of the grid, -1 = none.
  std::vector<std::int32_t> firstEntry_;
  std::vector<Entry> entries_;
  /// Cells that have entries.
  std::vector<std::size_t> usedCells_;
  ClaimSquares squares_;
  ClaimReturns found_;
  /// The first box that claims each return found outright, and as residue, -1 = none. Only grow.
  std::vector<std::int32_t> outright_, residue_;
  /// Only grows; the first `claimCount_` are those of the scan.
  std::vector<Claim> claims_;
  std::size_t claimCount_ = 0, residueCount_ = 0;
};

}  // namespace toss
