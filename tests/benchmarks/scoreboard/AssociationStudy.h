// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace toss {

/// Time of one way to associate by the number of traces.
struct AssociationCurve {
  /// Name for tables.
  std::string method;
  /// Traces of each problem, ascending, and the median time on it [ms]; same shape.
  std::vector<int> sizes;
  std::vector<double> milliseconds;
  /// Slope of the least-squares line through the last five points, both axes logarithmic: the
  /// growth of the time is N to the power of it. NaN for fewer points.
  double exponent = 0.0;

  /// Time [ms] at one of the sizes; NaN where it was not measured.
  double at(int size) const;
};

/// How often hierarchical association chooses what exhaustive association chooses.
struct AssociationAgreement {
  /// Traces per square metre.
  double density = 0.0;
  /// Pairs of the exhaustive method over all frames, and those of them that the other has too.
  std::size_t pairs = 0, equal = 0;
};

/// The study behind the paper's Table 2, on random boxes of people and cars.
struct AssociationStudy {
  /// Hierarchical, exhaustive with gates, and Auto-MOS's matrix.
  std::vector<AssociationCurve> curves;
  /// At the two realistic densities of spec section 5.6.
  std::vector<AssociationAgreement> agreements;
};

/// Candidates per box, the paper's k; traces per square metre where times are taken.
constexpr int kStudyCandidates = 5;
constexpr double kStudyDensity = 0.033;
/// Sizes at which the speed-up is told, beside those of the curves' doubling steps.
constexpr int kSpeedUpSizes[] = {300, 3000};

/// Measures in this thread, about three seconds; nothing else should run meanwhile.
AssociationStudy studyAssociation();

}  // namespace toss
