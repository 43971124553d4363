// SPDX-License-Identifier: BSD-3-Clause
#include <toss/visibility/FreeSpaceWitness.h>

#include <cmath>
#include <utility>

namespace toss {
namespace {

/// How far a view's age may be from the wanted one: logs of other rates, dropped scans.
double tolerance(double offset) {
  return 0.2 * offset + 0.02;
}

void testify(const RangeView& view, const Eigen::Vector3d& position, const EvidenceCells& cells,
             Testimony& testimony) {
  view.testify(cells.x.data(), cells.y.data(), cells.z.data(), cells.size(), position,
               testimony.freeViews.data(), testimony.hitViews.data(),
               testimony.glimpseViews.data());
}

}  // namespace

FreeSpaceWitness::FreeSpaceWitness(const VisibilityOptions& options)
    : options_(options), spareView_(options) {
  options_.check();
  offsets_ = options_.offsetSeconds();
}

void FreeSpaceWitness::exchange(Scan& earlier, Scan& later) const {
  testify(earlier.view, later.position, later.cells, later.cells.past);
  testify(later.view, earlier.position, earlier.cells, earlier.cells.later);
}

void FreeSpaceWitness::add(double time, const RangeImage& image, const PointCloud& points,
                           const Eigen::Isometry3d& mapFromSensor, EvidenceCells cells) {
  scans_.push_back({time, mapFromSensor.translation(), std::move(cells), RangeView(options_)});
  Scan& latest = scans_.back();
  std::swap(latest.view, spareView_);
  latest.view.look(image, points, mapFromSensor, scratch_);
  std::size_t candidate = scans_.size() - 1;
  // Offsets ascend, so each asks an older scan than the one before, and none is asked twice.
  for (const double offset : offsets_) {
    const auto miss = [&](std::size_t i) { return std::fabs(time - scans_[i].time - offset); };
    if (candidate == 0) break;
    std::size_t best = candidate - 1;
    while (best > 0 && miss(best - 1) <= miss(best)) --best;
    if (miss(best) > tolerance(offset)) continue;
    exchange(scans_[best], latest);
    candidate = best;
  }
}

bool FreeSpaceWitness::isComplete(const Scan& scan) const {
  if (offsets_.empty()) return true;
  const double longest = offsets_.back();
  return scans_.back().time - scan.time > longest + tolerance(longest);
}

std::vector<EvidenceCells> FreeSpaceWitness::takeComplete(bool all) {
  std::vector<EvidenceCells> result;
  while (taken_ < scans_.size() && (all || isComplete(scans_[taken_])))
    result.push_back(std::move(scans_[taken_++].cells));
  while (taken_ > 0 && isComplete(scans_.front())) {
    std::swap(scans_.front().view, spareView_);
    scans_.pop_front();
    --taken_;
  }
  return result;
}

}  // namespace toss
