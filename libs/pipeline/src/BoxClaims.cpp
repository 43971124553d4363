// SPDX-License-Identifier: BSD-3-Clause
#include "BoxClaims.h"

#include <toss/geometry/ProcessorVariants.h>

#include <algorithm>
#include <array>

#include "ClaimGrid.h"

namespace toss {
namespace {

using Takes = BoxClaims::Claimant::Takes;

/// The lowest part of an object lies in the ground layer or is too sparse to be in its instance.
constexpr double kBelowBox = 1.0;
/// More than any box takes.
constexpr std::int32_t kNever = static_cast<std::int32_t>(Takes::Residue) + 1;

}  // namespace

float BoxClaims::reachOf(Takes takes) const {
  return takes == Takes::Residue ? std::max(margins_.claim, margins_.residue) : margins_.claim;
}

void BoxClaims::enter(const Claimant& claimant, std::int32_t number) {
  const Takes takes = claimant.takes;
  const ClaimFootprint& footprint = footprints_[static_cast<std::size_t>(number)];
  terms_[static_cast<std::size_t>(number)] = {takes, claimant.instance,
                                              footprint.extent(reachOf(takes))};
  ClaimBox& box = boxes_[static_cast<std::size_t>(number)];
  box = ClaimBox::at(footprint, number);
  box.takes = static_cast<std::int32_t>(takes);
  box.claim = ClaimBox::Reach::of(footprint, margins_.claim);
  if (claimsResidue(takes)) box.residue = ClaimBox::Reach::of(footprint, margins_.residue);
  ClaimGrid::visitCells(footprint.extent(reachOf(takes) + ClaimGrid::kRounding),
                        [&](std::size_t cell) {
                          if (firstEntry_[cell] < 0) usedCells_.push_back(cell);
                          entries_.push_back({number, firstEntry_[cell]});
                          firstEntry_[cell] = static_cast<std::int32_t>(entries_.size()) - 1;
                        });
}

void BoxClaims::take(const std::vector<Claimant>& claimants,
                     const Eigen::Vector3d& sensorPosition) {
  firstEntry_.resize(static_cast<std::size_t>(ClaimGrid::kCells) * ClaimGrid::kCells, -1);
  for (const std::size_t cell : usedCells_) firstEntry_[cell] = -1;
  usedCells_.clear(), entries_.clear(), footprints_.clear(), byVolume_.clear();
  terms_.resize(claimants.size()), boxes_.resize(claimants.size());
  instanceOf_.assign(1, 0);
  for (std::size_t c = 0; c < claimants.size(); ++c) {
    footprints_.emplace_back(claimants[c].box, sensorPosition, kBelowBox);
    instanceOf_.push_back(claimants[c].instance);
    byVolume_.emplace_back(-claimants[c].box.volume(), static_cast<std::int32_t>(c));
  }
  std::sort(byVolume_.begin(), byVolume_.end());
  // Entered last means found first: larger boxes go in before smaller ones.
  for (const auto& [volume, number] : byVolume_)
    enter(claimants[static_cast<std::size_t>(number)], number);
}

bool BoxClaims::isMet(std::size_t number) const {
  const Eigen::AlignedBox2f own = footprints_[number].extent(0.0f);
  bool met = false;
  ClaimGrid::visitCells(own, [&](std::size_t cell) {
    for (std::int32_t e = firstEntry_[cell]; e >= 0 && !met;
         e = entries_[static_cast<std::size_t>(e)].next) {
      const auto other = static_cast<std::size_t>(entries_[static_cast<std::size_t>(e)].box);
      const Terms& terms = terms_[other];
      met = other != number && terms.takes != Takes::Nothing && terms.claimed.intersects(own);
    }
  });
  return met;
}

void BoxClaims::findNearby(const LevelPoints& points, const Segmentation& segmentation,
                           const std::vector<bool>& standing) {
  cuttable_ = standing;
  squares_.clear();
  for (std::size_t c = 0; c < terms_.size(); ++c) {
    const Terms& terms = terms_[c];
    if (const auto own = static_cast<std::size_t>(terms.instance); own != 0)
      cuttable_[own] = cuttable_[own] && isMet(c);
    squares_.mark(footprints_[c], {reachOf(terms.takes), terms.takes != Takes::Nothing,
                                   claimsResidue(terms.takes), terms.instance});
  }
  squares_.find(points, segmentation, residueHeight_, cuttable_, found_);
}

TOSS_ALSO_FOR_AVX2
void BoxClaims::askBoxes() {
  ClaimBatch batch;
  for (std::size_t s = 0; s < found_.stretchCount; ++s) {
    const auto first = static_cast<std::size_t>(found_.stretch[s]);
    const auto end = static_cast<std::size_t>(found_.stretch[s + 1]);
    const std::int32_t firstEntry = firstEntry_[found_.cell[first]];
    for (std::size_t i = first; i < end; i += ClaimBatch::kMost) {
      batch.take(found_, i, static_cast<std::int32_t>(Takes::Cuts), kNever);
      for (std::int32_t e = firstEntry; e >= 0; e = entries_[static_cast<std::size_t>(e)].next)
        batch.ask(boxes_[static_cast<std::size_t>(entries_[static_cast<std::size_t>(e)].box)]);
      // Answers behind the end of the stretch are replaced by those of the next.
      batch.write(outright_.data() + i, residue_.data() + i);
    }
  }
}

/// Without branches, as no one could foretell which returns are claimed.
void BoxClaims::takeClaims(const Segmentation& segmentation) {
  claimCount_ = residueCount_ = 0;
  for (std::size_t i = 0; i < found_.count; ++i) {
    const bool residue = outright_[i] < 0;
    const std::int32_t claimant = residue ? residue_[i] : outright_[i];
    const std::int32_t host = segmentation.instance[static_cast<std::size_t>(found_.point[i])];
    const bool own = (host != 0) & (instanceOf_[static_cast<std::size_t>(claimant + 1)] == host);
    claims_[claimCount_] = {found_.point[i], claimant, host, residue};
    const bool taken = (claimant >= 0) & !own;
    claimCount_ += taken;
    residueCount_ += taken & residue;
  }
}

BoxClaims::Claims BoxClaims::find(const LevelPoints& points, const Segmentation& segmentation,
                                  const std::vector<bool>& standing) {
  findNearby(points, segmentation, standing);
  if (const std::size_t size = found_.count + ClaimReturns::kSpare; claims_.size() < size)
    claims_.resize(size), outright_.resize(size), residue_.resize(size);
  askBoxes();
  takeClaims(segmentation);
  return {claims_.data(), claims_.data() + claimCount_, residueCount_};
}

std::int32_t BoxClaims::boxAround(const Eigen::Vector3f& point, std::int32_t except) const {
  const std::int32_t square = ClaimGrid::squareOf(point.x(), point.y());
  for (std::int32_t e = firstEntry_[ClaimGrid::cellOfSquare(square)]; e >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(e)];
    e = entry.next;
    if (entry.box == except) continue;
    if (footprints_[static_cast<std::size_t>(entry.box)].holds(point, margins_.claim))
      return entry.box;
  }
  return -1;
}

}  // namespace toss
