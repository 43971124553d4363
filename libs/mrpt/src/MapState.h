// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/CSimplePointsMap.h>
#include <toss/mrpt/CDynamicFilteredPointsMap.h>

#include <mutex>

#include "MappingSession.h"

namespace toss {

/// What the map holds, behind one lock.
struct CDynamicFilteredPointsMap::State {
  mutable std::mutex mutex;
  /// Result of the sessions that are finished, never null; not changed, but replaced.
  mrpt::maps::CPointsMapXYZI::Ptr kept = mrpt::maps::CPointsMapXYZI::Create();
  /// The session that is going on, null if none.
  std::unique_ptr<MappingSession> session;

  /// The map by present knowledge, at most PlugInOptions::refreshScans old. Call with the lock
  /// held.
  const mrpt::maps::CPointsMapXYZI& present();
  const mrpt::maps::CSimplePointsMap& presentSimple();
  /// Ends the session. Call with the lock held.
  void finish();
  /// Replaces everything by a map that is finished. Call with the lock held.
  void reset(mrpt::maps::CPointsMapXYZI::Ptr points);

 private:
  /// kept and session together, as they were after `viewScans` scans; null if out of date.
  mrpt::maps::CPointsMapXYZI::Ptr view_;
  mrpt::maps::CSimplePointsMap::Ptr simple_;
  std::uint64_t viewScans_ = 0;
};

}  // namespace toss
