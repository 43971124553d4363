// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/GroundNodeModel.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Layers under the ground that are looked through before the lowest is believed.
constexpr int kReflectionLayers = 3;

/// A layer of returns no thicker than th_seeds.
struct Layer {
  float bottom = 0.0f, top = 0.0f;
  std::size_t count = 0;
};

/// Step from one return to the next that the fit looks at.
std::size_t strideOf(const NodePoints& points, const GroundOptions& options) {
  if (options.maxFitPoints == 0) return 1;
  const auto most = static_cast<std::size_t>(options.maxFitPoints);
  return std::max<std::size_t>(1, (points.count + most - 1) / most);
}

/// Mean height of the lowest returns that lie above `floor`; infinity where there is none.
float meanOfLowest(const NodePoints& points, std::size_t stride, float floor, std::size_t wanted) {
  float lowest[64];
  std::size_t found = 0;
  for (std::size_t i = 0; i < points.count; i += stride) {
    const float z = points[i].z;
    if (z <= floor || (found == wanted && z >= lowest[found - 1])) continue;
    if (found < wanted) ++found;
    std::size_t place = found - 1;
    for (; place > 0 && lowest[place - 1] > z; --place) lowest[place] = lowest[place - 1];
    lowest[place] = z;
  }
  if (found == 0) return kInfinity;
  float sum = 0.0f;
  for (std::size_t i = 0; i < found; ++i) sum += lowest[i];
  return sum / static_cast<float>(found);
}

Layer layerAbove(const NodePoints& points, float floor, const GroundOptions& options) {
  Layer layer;
  const std::size_t stride = strideOf(points, options);
  layer.bottom =
      meanOfLowest(points, stride, floor, static_cast<std::size_t>(options.lowestPoints));
  layer.top = layer.bottom;
  const float limit = layer.bottom + static_cast<float>(options.seedHeight);
  for (std::size_t i = 0; i < points.count; i += stride) {
    const float z = points[i].z;
    if (z <= floor || z > limit) continue;
    layer.count += stride;
    layer.top = std::max(layer.top, z);
  }
  return layer;
}

/// Running sums of selected returns, relative to the node's first return against cancellation.
struct Moments {
  double count = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(double px, double py, double pz) {
    count += 1.0, x += px, y += py, z += pz;
    xx += px * px, xy += px * py, xz += px * pz;
    yy += py * py, yz += py * pz, zz += pz * pz;
  }
};

/// Sets the node's plane; returns the spread of the returns across their line [m].
double fitPlane(const Moments& sums, const Eigen::Vector3d& origin, GroundNode& node) {
  const Eigen::Vector3d mean = Eigen::Vector3d(sums.x, sums.y, sums.z) / sums.count;
  Eigen::Matrix3d covariance;
  covariance << sums.xx, sums.xy, sums.xz, sums.xy, sums.yy, sums.yz, sums.xz, sums.yz, sums.zz;
  covariance = covariance / sums.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  Eigen::Vector3d normal = solver.eigenvectors().col(0).normalized();
  if (normal.z() < 0.0) normal = -normal;
  const Eigen::Vector3d center = mean + origin;
  const Eigen::Vector3d s = solver.eigenvalues().cwiseMax(0.0);
  node.normal = normal.cast<float>();
  node.mean = center.cast<float>();
  node.offset = static_cast<float>(-normal.dot(center));
  node.weight = static_cast<float>((s[2] + s[1]) * s[1] / (s[2] * s[0] + 0.001));
  return std::sqrt(s[1]);
}

}  // namespace

float lowestLayer(const NodePoints& points, const GroundOptions& options) {
  Layer layer = layerAbove(points, -kInfinity, options);
  for (int i = 0; i < kReflectionLayers; ++i) {
    const auto share = static_cast<float>(options.minLayerShare);
    if (static_cast<float>(layer.count) >= share * static_cast<float>(points.count)) break;
    const Layer next = layerAbove(points, layer.top, options);
    const bool thin = static_cast<float>(layer.count) < share * static_cast<float>(next.count);
    if (!thin || next.bottom - layer.top < static_cast<float>(options.outlierDepth)) break;
    layer = next;
  }
  return layer.bottom;
}

GroundNode fitGroundNode(const NodePoints& points, const GroundOptions& options) {
  GroundNode node;
  if (points.count < static_cast<std::size_t>(options.minPoints)) return node;
  const Eigen::Vector3d origin(points[0].x, points[0].y, points[0].z);
  const auto x0 = points[0].x, y0 = points[0].y, z0 = points[0].z;
  const auto below = static_cast<float>(options.groundHeight);
  const std::size_t stride = strideOf(points, options);
  const float bottom = lowestLayer(points, options);
  const float floor = bottom - static_cast<float>(options.outlierDepth);
  const float ceiling = bottom + static_cast<float>(options.seedHeight);

  double spread = 0.0;
  for (int round = 0; round < options.iterations; ++round) {
    Moments sums;
    for (std::size_t i = 0; i < points.count; i += stride) {
      const float x = points[i].x, y = points[i].y, z = points[i].z;
      const bool seed = z >= floor && z < ceiling;
      const bool near = z >= floor && node.heightOf(x, y, z) < below;
      if (round == 0 ? seed : near) {
        sums.add(static_cast<double>(x - x0), static_cast<double>(y - y0),
                 static_cast<double>(z - z0));
      }
    }
    if (sums.count < 3.0) {
      node.type = NodeType::NonGround;
      return node;
    }
    spread = fitPlane(sums, origin, node);
  }
  // The returns of a single beam lie on a line, through which any plane fits.
  if (spread < options.minSpread) return GroundNode{};
  const bool level = node.normal.z() >= static_cast<float>(options.minNormalZ);
  node.type = level ? NodeType::Ground : NodeType::NonGround;
  return node;
}

}  // namespace toss
