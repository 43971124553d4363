// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Track.h>
#include <tsl/robin_map.h>

#include <Eigen/Geometry>
#include <vector>

#include "VoterGrid.h"

namespace toss {

/// The traces that boxes in the grid belong to: their class, and where their boxes are.
class TraceList {
 public:
  using TraceIndex = std::uint32_t;

  TraceList() { traces_.emplace_back(); }

  MotionClass motion(TraceIndex trace) const { return traces_[trace].motion; }
  /// Voter::kNoTrace for a trace that is not known.
  TraceIndex find(TrackId track) const;
  /// Raises or lowers the class; makes the trace known. `time` [s]: of the last scan.
  TraceIndex setMotion(TrackId track, MotionClass motion, double time);

  /// Trace of a box, made known as static where it is not; kNoTrace for track 0.
  TraceIndex indexOf(TrackId track);
  /// `center`: of the box [m, map frame].
  void addBox(TraceIndex trace, VoterGrid::CellIndex cell, const Eigen::Vector3d& center);
  /// Gives up the trace with its last box.
  void removeBox(TraceIndex trace, VoterGrid::CellIndex cell);
  /// Gives up traces that were named before `time` [s] and have no boxes.
  void forgetUnused(double time);

  /// A cell and what it holds of a trace: how many boxes, and where the centres of these lie, and
  /// of those that were there before [m, map frame].
  struct CellCount {
    VoterGrid::CellIndex cell;
    int boxes;
    Eigen::AlignedBox3d centers;
  };
  /// Cells that hold boxes of the trace, each once.
  const std::vector<CellCount>& cells(TraceIndex trace) const { return traces_[trace].cells; }

 private:
  struct Trace {
    TrackId id = 0;
    MotionClass motion = MotionClass::Static;
    /// In the order in which the trace came to the cells.
    std::vector<CellCount> cells;
  };
  struct Naming {
    double time;
    TrackId track;
  };
  void giveUp(TraceIndex trace);

  tsl::robin_map<TrackId, TraceIndex> indexOf_;
  std::vector<Trace> traces_;
  std::vector<TraceIndex> free_;
  std::vector<Naming> named_;
};

}  // namespace toss
