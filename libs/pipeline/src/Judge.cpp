// SPDX-License-Identifier: BSD-3-Clause
#include "Judge.h"

namespace toss {

namespace {

/// Instances come before what is claimed out of them.
bool isHostMoving(const Owner& owner, const std::vector<bool>& moving) {
  return owner.host != 0 && moving[static_cast<std::size_t>(owner.host)];
}

}  // namespace

std::vector<bool> Judge::live(const ScanRecord& record,
                              const std::vector<FreeSpaceSum>& evidence) const {
  DecisionOptions options = options_;
  options.freeShare = options_.liveFreeShare;
  std::vector<bool> moving(record.owners.size(), false);
  for (std::size_t o = 1; o < moving.size(); ++o) {
    const Owner& owner = record.owners[o];
    const MotionClass trace = traces_.liveClass(owner.track);
    const bool voted = isDynamic(trace) || (owner.votes && voting_.isDynamic(owner.box));
    const FreeSpaceSum own = o < evidence.size() ? evidence[o] : FreeSpaceSum();
    moving[o] = fuseInstance(voted, trace, own, options) || isHostMoving(owner, moving);
  }
  return moving;
}

std::vector<bool> Judge::final(const ScanRecord& record, bool last) const {
  std::vector<bool> moving(record.owners.size(), false);
  for (std::size_t o = 1; o < moving.size(); ++o) {
    const Owner& owner = record.owners[o];
    const MotionClass trace = traces_.finalClass(owner.track, last);
    const bool voted = owner.votes ? voting_.isDynamic(owner.box) : isDynamic(trace);
    moving[o] = fuseInstance(voted, trace, owner.evidence, options_) || isHostMoving(owner, moving);
  }
  return moving;
}

void Judge::findLoneMovers(const EvidenceCells& cells, ScanRecord& record) const {
  for (std::size_t i = 0; i < cells.lonePoint.size(); ++i) {
    const auto cell = static_cast<std::size_t>(cells.loneCell[i]);
    const int freeViews = cells.past.freeViews[cell] + cells.later.freeViews[cell];
    if (!isHit(cells, cell) && freeViews >= options_.loneFreeViews)
      record.loneMovers.push_back(cells.lonePoint[i]);
  }
}

}  // namespace toss
