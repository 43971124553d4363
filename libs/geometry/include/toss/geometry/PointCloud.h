// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// The returns of one scan, struct of arrays, in the order in which the input holds them. Every
/// per-point result of TOSS is index-aligned with this order; no stage drops or reorders a point.
struct PointCloud {
  /// Coordinates [m], sensor frame (x forward, y left, z up), shape [n]. May hold NaN and (0,0,0).
  std::vector<float> x, y, z;
  /// Reflectivity as the input gives it (KITTI and MRPT: 0..1), shape [n] or empty if unknown.
  std::vector<float> intensity;
  /// Beam index, 0 = the topmost beam, shape [n] or empty if the input does not tell.
  std::vector<std::uint16_t> ring;
  /// Time of each return relative to the scan's time stamp [s], shape [n] or empty if unknown.
  std::vector<float> time;

  std::size_t size() const { return x.size(); }
  bool empty() const { return x.empty(); }

  /// Sets the number of points of x, y, z and intensity; ring and time become empty.
  void resize(std::size_t n) {
    x.resize(n), y.resize(n), z.resize(n), intensity.resize(n);
    ring.clear(), time.clear();
  }
};

}  // namespace toss
