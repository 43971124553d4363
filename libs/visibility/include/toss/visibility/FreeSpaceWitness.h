// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/visibility/EvidenceCells.h>
#include <toss/visibility/RangeView.h>

#include <cstdint>
#include <deque>
#include <vector>

namespace toss {

/// Lets scans testify about each other (spec section 12): each new scan is asked about the returns
/// of earlier ones, and they about its own, at the ages of VisibilityOptions::offsets. Memory: the
/// views and cells of the longest offset.
class FreeSpaceWitness {
 public:
  /// Throws UserError for options out of range.
  explicit FreeSpaceWitness(const VisibilityOptions& options);

  /// Adds a scan, later than the last one. `cells` come back with the evidence of past views alone
  /// (the live evidence) through latest(); later views add to them until takeComplete() hands them
  /// out.
  void add(double time, const RangeImage& image, const PointCloud& points,
           const Eigen::Isometry3d& mapFromSensor, EvidenceCells cells);

  /// The cells of the scan that was added last. Call only while it is not taken yet.
  const EvidenceCells& latest() const { return scans_.back().cells; }

  /// Cells of the scans that no later view will be asked about any more, in order of their coming;
  /// each scan comes out once. With `all`, the log has ended: those of all that are left.
  std::vector<EvidenceCells> takeComplete(bool all = false);

 private:
  struct Scan {
    double time;
    Eigen::Vector3d position;
    EvidenceCells cells;
    RangeView view;
  };
  void exchange(Scan& earlier, Scan& later) const;
  bool isComplete(const Scan& scan) const;

  VisibilityOptions options_;
  std::vector<double> offsets_;
  std::deque<Scan> scans_;
  /// Scans at the front of scans_ whose cells have been taken; their views still serve.
  std::size_t taken_ = 0;
  /// The view of a scan that is over, whose memory the next one takes.
  RangeView spareView_;
  RangeView::Scratch scratch_;
};

}  // namespace toss
