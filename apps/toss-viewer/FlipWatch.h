// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "LiveFrame.h"

namespace toss {

/// Follows the traces from scan to scan: their ways, and when the verdict about one changes.
class FlipWatch {
 public:
  /// The traces that were seen in the scan, those first that move; `labels` are its live ones.
  std::vector<LiveTrace> update(const ScanLabels& labels);
  /// Changes so far.
  std::size_t flips() const { return flips_; }

 private:
  struct Known {
    bool moving = false;
    double flipTime = -1e9, lastTime = 0.0;
    std::vector<Eigen::Vector3d> path;
  };
  void forgetOld(double now);

  std::map<TrackId, Known> known_;
  std::size_t flips_ = 0;
};

}  // namespace toss
