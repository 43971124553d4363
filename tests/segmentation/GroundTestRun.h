// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundSegmentation.h>
#include <toss/segmentation/LevelFrame.h>
#include <toss/segmentation/RangeImageProjection.h>

#include <cmath>
#include <functional>

#include "GroundTestScene.h"

namespace toss::test {

/// Shares of returns over a scan, for one surface of its scene.
struct GroundShares {
  int count = 0;
  double ground = 0.0, below = 0.0, unknownHeight = 0.0;
};

/// A scan of a test scene after projection and ground segmentation.
struct GroundTestRun {
  GroundTestScene::Scan scan;
  RangeImage image;
  LevelPoints level;
  Segmentation segmentation;

  GroundTestRun(const GroundTestScene::Scan& given, const SensorModel& sensor,
                const GroundOptions& options)
      : scan(given) {
    RangeImageProjection projection(ProjectionOptions{}, sensor);
    projection.project(scan.posed.points, image, segmentation.pointClass);
    toLevelFrame(scan.posed.points, scan.posed.mapFromSensor, level);
    GroundSegmentation(options).segment(level, image, segmentation);
  }

  Eigen::Vector3d mapPoint(std::size_t i) const {
    return scan.posed.mapFromSensor.translation() +
           Eigen::Vector3d(static_cast<double>(level.x[i]), static_cast<double>(level.y[i]),
                           static_cast<double>(level.z[i]));
  }

  using Filter = std::function<bool(const Eigen::Vector3d& mapPoint, double range)>;

  /// Shares of the returns on `surface` that `filter` lets through.
  GroundShares shares(GroundTestScene::Surface surface, const Filter& filter = nullptr) const {
    GroundShares result;
    for (std::size_t i = 0; i < scan.surface.size(); ++i) {
      if (scan.surface[i] != surface || image.row[i] == RangeImage::kNoRow) continue;
      if (filter && !filter(mapPoint(i), static_cast<double>(image.range[i]))) continue;
      ++result.count;
      result.ground += segmentation.pointClass[i] == PointClass::Ground;
      result.below += segmentation.pointClass[i] == PointClass::BelowGround;
      result.unknownHeight += std::isnan(segmentation.heightAboveGround[i]);
    }
    const double count = std::max(1, result.count);
    result.ground /= count, result.below /= count, result.unknownHeight /= count;
    return result;
  }
};

}  // namespace toss::test
