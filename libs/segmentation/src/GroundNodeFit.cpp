// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/GroundNodeFit.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Layers under the ground that are looked through before the lowest is believed.
constexpr int kReflectionLayers = 3;

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

// The compiler vectorises these only as functions of arrays that are known not to overlap.

TOSS_ALSO_FOR_AVX2
void selectBetween(const float* __restrict z, std::size_t n, float floor, float ceiling,
                   std::uint8_t* __restrict near) {
  for (std::size_t i = 0; i < n; ++i)
    near[i] = static_cast<std::uint8_t>((z[i] >= floor) & (z[i] < ceiling));
}

TOSS_ALSO_FOR_AVX2
void selectBelow(const GroundNode& node, const float* __restrict x, const float* __restrict y,
                 const float* __restrict z, std::size_t n, float floor, float height,
                 std::uint8_t* __restrict near) {
  const float a = node.normal.x(), b = node.normal.y(), c = node.normal.z(), d = node.offset;
  for (std::size_t i = 0; i < n; ++i) {
    const float above = a * x[i] + b * y[i] + c * z[i] + d;
    near[i] = static_cast<std::uint8_t>((z[i] >= floor) & (above < height));
  }
}

}  // namespace

/// Picks returns evenly.
void GroundNodeFit::pick(const NodePoints& points) {
  count_ = points.count;
  const auto most = static_cast<std::size_t>(options_.maxFitPoints);
  stride_ = most == 0 ? 1 : std::max<std::size_t>(1, (count_ + most - 1) / most);
  const std::size_t n = (count_ + stride_ - 1) / stride_;
  x_.resize(n), y_.resize(n), z_.resize(n), near_.resize(n), selected_.resize(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const NodePoint& point = points[i * stride_];
    x_[i] = point.x, y_[i] = point.y, z_[i] = point.z;
  }
}

/// Mean height of the lowest returns that lie above `floor`; infinity where there is none.
float GroundNodeFit::meanOfLowest(float floor) const {
  const auto wanted = static_cast<std::size_t>(options_.lowestPoints);
  float lowest[64];
  std::size_t found = 0;
  for (const float z : z_) {
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

GroundNodeFit::Layer GroundNodeFit::layerAbove(float floor) const {
  Layer layer;
  layer.bottom = meanOfLowest(floor);
  layer.top = layer.bottom;
  const float limit = layer.bottom + static_cast<float>(options_.seedHeight);
  // Without branches, as no one could foretell on which side of the limit a return lies.
  for (const float z : z_) {
    const bool inside = (z > floor) & (z <= limit);
    layer.count += inside ? stride_ : 0;
    layer.top = std::max(layer.top, inside ? z : layer.top);
  }
  return layer;
}

float GroundNodeFit::lowestLayer() const {
  Layer layer = layerAbove(-kInfinity);
  for (int i = 0; i < kReflectionLayers; ++i) {
    const auto share = static_cast<float>(options_.minLayerShare);
    if (static_cast<float>(layer.count) >= share * static_cast<float>(count_)) break;
    const Layer next = layerAbove(layer.top);
    const bool thin = static_cast<float>(layer.count) < share * static_cast<float>(next.count);
    if (!thin || next.bottom - layer.top < static_cast<float>(options_.outlierDepth)) break;
    layer = next;
  }
  return layer.bottom;
}

float GroundNodeFit::lowestLayer(const NodePoints& points) {
  pick(points);
  return lowestLayer();
}

/// Selects what the next round fits: a layer at `bottom`, or what is near the plane of `node`.
void GroundNodeFit::select(bool asSeeds, float bottom, const GroundNode& node) {
  const std::size_t n = z_.size();
  const float floor = bottom - static_cast<float>(options_.outlierDepth);
  if (asSeeds) {
    selectBetween(z_.data(), n, floor, bottom + static_cast<float>(options_.seedHeight),
                  near_.data());
  } else {
    selectBelow(node, x_.data(), y_.data(), z_.data(), n, floor,
                static_cast<float>(options_.groundHeight), near_.data());
  }
  selectedCount_ = 0;
  for (std::size_t i = 0; i < n; ++i) {
    selected_[selectedCount_] = static_cast<std::int32_t>(i);
    selectedCount_ += near_[i];
  }
}

GroundNode GroundNodeFit::fit(const NodePoints& points) {
  GroundNode node;
  if (points.count < static_cast<std::size_t>(options_.minPoints)) return node;
  pick(points);
  const float x0 = x_.front(), y0 = y_.front(), z0 = z_.front();
  const Eigen::Vector3d origin(x0, y0, z0);
  const float bottom = lowestLayer();
  double spread = 0.0;
  for (int round = 0; round < options_.iterations; ++round) {
    select(round == 0, bottom, node);
    Moments sums;
    for (std::size_t s = 0; s < selectedCount_; ++s) {
      const auto i = static_cast<std::size_t>(selected_[s]);
      sums.add(static_cast<double>(x_[i] - x0), static_cast<double>(y_[i] - y0),
               static_cast<double>(z_[i] - z0));
    }
    if (sums.count < 3.0) {
      node.type = NodeType::NonGround;
      return node;
    }
    spread = fitPlane(sums, origin, node);
  }
  // The returns of a single beam lie on a line, through which any plane fits.
  if (spread < options_.minSpread) return GroundNode{};
  const bool level = node.normal.z() >= static_cast<float>(options_.minNormalZ);
  node.type = level ? NodeType::Ground : NodeType::NonGround;
  return node;
}

}  // namespace toss
