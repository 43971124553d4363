// SPDX-License-Identifier: BSD-3-Clause
#include "MapState.h"

#include <toss/rawlog/MetricMapFile.h>

namespace toss {
namespace {

using mrpt::maps::CPointsMapXYZI;

CPointsMapXYZI::Ptr joined(const CPointsMapXYZI::Ptr& kept, const std::vector<MapPoint>& points) {
  CPointsMapXYZI::Ptr added = toPointsMap(points);
  if (kept->empty()) return added;
  auto all = std::make_shared<CPointsMapXYZI>(*kept);
  all->insertAnotherMap(added.get(), mrpt::poses::CPose3D());
  return all;
}

}  // namespace

const CPointsMapXYZI& CDynamicFilteredPointsMap::State::present() {
  if (!session) return *kept;
  const std::uint64_t scans = session->scanCount();
  if (!view_ || scans >= viewScans_ + static_cast<std::uint64_t>(session->refreshScans())) {
    view_ = joined(kept, session->presentMap());
    viewScans_ = scans;
    simple_.reset();
  }
  return *view_;
}

const mrpt::maps::CSimplePointsMap& CDynamicFilteredPointsMap::State::presentSimple() {
  const CPointsMapXYZI& points = present();
  if (!simple_) {
    simple_ = mrpt::maps::CSimplePointsMap::Create();
    *simple_ = points;
  }
  return *simple_;
}

void CDynamicFilteredPointsMap::State::finish() {
  if (session) reset(joined(kept, session->finish()));
}

void CDynamicFilteredPointsMap::State::reset(CPointsMapXYZI::Ptr points) {
  kept = std::move(points);
  session.reset();
  view_.reset();
  simple_.reset();
  viewScans_ = 0;
}

}  // namespace toss
