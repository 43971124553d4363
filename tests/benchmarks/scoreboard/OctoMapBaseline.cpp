// SPDX-License-Identifier: BSD-3-Clause
#include "OctoMapBaseline.h"

#include <octomap/OcTree.h>
#include <toss/rawlog/LabelFile.h>

#include <chrono>
#include <cmath>

namespace toss {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kCellSize = 0.2;

octomap::point3d toPoint(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// Whether return i of the scan is one, and where it is in the map.
bool inMap(const PosedScan& scan, std::size_t i, Eigen::Vector3d& point) {
  const Eigen::Vector3d p(scan.points.x[i], scan.points.y[i], scan.points.z[i]);
  point = scan.mapFromSensor * p;
  return std::isfinite(p.squaredNorm()) && p.squaredNorm() > 0.0;
}

void insert(const PosedScan& scan, octomap::OcTree& tree) {
  octomap::Pointcloud cloud;
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (inMap(scan, i, point)) cloud.push_back(toPoint(point));
  constexpr double kNoLimit = -1.0;
  constexpr bool kLazy = true, kOncePerCell = true;
  tree.insertPointCloud(cloud, toPoint(scan.mapFromSensor.translation()), kNoLimit, kLazy,
                        kOncePerCell);
}

std::vector<std::uint32_t> labelsOf(const PosedScan& scan, const octomap::OcTree& tree) {
  std::vector<std::uint32_t> labels(scan.points.size(), label::kInvalid);
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!inMap(scan, i, point)) continue;
    const octomap::OcTreeNode* node = tree.search(toPoint(point));
    labels[i] = node != nullptr && tree.isNodeOccupied(node) ? label::kStatic : label::kMoving;
  }
  return labels;
}

}  // namespace

bool hasOctoMap() {
  return true;
}

MethodRun runOctoMap(const LabelledLog& log) {
  octomap::OcTree tree(kCellSize);
  MethodRun run;
  for (const PosedScan& scan : log.scans) {
    const Clock::time_point start = Clock::now();
    insert(scan, tree);
    run.milliseconds.push_back(
        std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  tree.updateInnerOccupancy();
  for (const PosedScan& scan : log.scans) run.answers.push_back({labelsOf(scan, tree), {}, {}});
  return run;
}

}  // namespace toss
