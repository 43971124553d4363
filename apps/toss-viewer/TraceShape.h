// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Color.h>

#include <string>
#include <utility>
#include <vector>

#include "LiveFrame.h"

namespace toss {

using Segment = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

/// The edges of a trace's box, and if it moves, an arrow as long as its way in the next second.
std::vector<Segment> shapeOf(const LiveTrace& trace);
/// Yellow where the verdict has just changed, else the colour of a mover, else a dull one.
Color colorOf(const LiveTrace& trace);
/// Number and speed of a mover, e.g. "#12 8.3 m/s"; the number of what stands only if its verdict
/// has just changed, else "".
std::string captionOf(const LiveTrace& trace);
/// Where the caption stands: above the box.
Eigen::Vector3d captionPlace(const LiveTrace& trace);
/// One line for the status: scan, time, movers, changed verdicts, map, and ms per scan.
std::string statusOf(const LiveFrame& frame);

}  // namespace toss
