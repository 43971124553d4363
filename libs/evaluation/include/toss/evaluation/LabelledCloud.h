// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Points with their true label, struct of arrays.
struct LabelledCloud {
  /// Map frame minus the origin of the evaluation [m], shape [n]. The origin is a whole number of
  /// voxels, so that floats stay exact far from the map's origin and the grid stays where it is.
  std::vector<float> x, y, z;
  /// Low 16 bits: class of SemanticKITTI; high 16 bits: free for the caller. Shape [n].
  std::vector<std::uint32_t> label;

  std::size_t size() const { return x.size(); }
  bool empty() const { return x.empty(); }
  void clear() { x.clear(), y.clear(), z.clear(), label.clear(); }
  void add(float px, float py, float pz, std::uint32_t pointLabel) {
    x.push_back(px), y.push_back(py), z.push_back(pz), label.push_back(pointLabel);
  }
};

}  // namespace toss
