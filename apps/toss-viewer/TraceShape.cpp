// SPDX-License-Identifier: BSD-3-Clause
#include "TraceShape.h"

#include <algorithm>
#include <cstdio>

#include "LineDrawing.h"
#include "LiveColors.h"
#include "Picture.h"

namespace toss {
namespace {

void addArrow(const LiveTrace& trace, std::vector<Segment>& segments) {
  Eigen::Vector3d way = trace.sample.velocity;
  way.z() = 0.0;
  if (way.norm() < 0.3) return;
  const Eigen::Vector3d from = trace.sample.box.center, to = from + way;
  const double head = std::min(1.0, 0.3 * way.norm());
  const Eigen::Vector3d along = way.normalized(), aside(-along.y(), along.x(), 0.0);
  segments.emplace_back(from, to);
  segments.emplace_back(to, to - head * (along + 0.5 * aside));
  segments.emplace_back(to, to - head * (along - 0.5 * aside));
}

}  // namespace

std::vector<Segment> shapeOf(const LiveTrace& trace) {
  const auto edges = edgesOf(trace.sample.box);
  std::vector<Segment> segments(edges.begin(), edges.end());
  if (trace.sample.moving) addArrow(trace, segments);
  return segments;
}

Color colorOf(const LiveTrace& trace) {
  if (trace.flipped) return kFlipColor;
  return trace.sample.moving ? kMovingColor : kStandingBoxColor;
}

std::string captionOf(const LiveTrace& trace) {
  if (!trace.sample.moving && !trace.flipped) return "";
  char text[64];
  if (trace.sample.moving)
    std::snprintf(text, sizeof text, "#%llu %.1f m/s",
                  static_cast<unsigned long long>(trace.sample.track),
                  trace.sample.velocity.head<2>().norm());
  else
    std::snprintf(text, sizeof text, "#%llu stands",
                  static_cast<unsigned long long>(trace.sample.track));
  return text;
}

Eigen::Vector3d captionPlace(const LiveTrace& trace) {
  return trace.sample.box.center + Eigen::Vector3d(0.0, 0.0, 0.5 * trace.sample.box.height + 0.4);
}

std::string statusOf(const LiveFrame& frame) {
  const auto movers = std::count_if(frame.traces.begin(), frame.traces.end(),
                                    [](const LiveTrace& trace) { return trace.sample.moving; });
  char head[96], tail[64];
  std::snprintf(head, sizeof head, "scan %llu   %.1f s   %td moving   %zu verdicts changed   map ",
                static_cast<unsigned long long>(frame.scan), frame.time, movers, frame.flips);
  std::snprintf(tail, sizeof tail, "   %.0f ms", frame.milliseconds);
  return head + countText(frame.map->size()) + tail;
}

}  // namespace toss
