// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "Scoreboard.h"

namespace toss {

/// A variant on a scene, means over its seeds.
struct SceneScore {
  int seeds = 0;
  /// Scans of the first seed.
  std::size_t scans = 0;
  /// [%], [%], 0 to 1; moving IoU [%], NaN where there is none.
  double preservation = 0.0, rejection = 0.0, f1 = 0.0, iou = 0.0, liveIou = 0.0;
  /// RR [%] that the right class for every instance, and for every trace, would reach.
  double instanceBound = 0.0, traceBound = 0.0;
  /// Time per scan [ms].
  double median = 0.0, percentile95 = 0.0;
};

/// The mean over the seeds. `seeds` is 0 where the variant did not run on the scene.
SceneScore sceneScore(const std::vector<CaseResult>& results, const std::string& scene,
                      const std::string& variant);

/// The result of a variant on seed 1 of a scene, nullptr where it did not run there.
const CaseResult* firstResult(const std::vector<CaseResult>& results, const std::string& scene,
                              const std::string& variant);

/// A number for tables and plots, "-" if it is not finite; with "+" where positive if `sign`.
std::string numberText(double value, int decimals, bool sign = false);

/// The scenes in the results, that with the lowest F1 of the default first.
std::vector<std::string> scenesWorstFirst(const std::vector<CaseResult>& results);

/// Means over the scenes of a variant minus the default's, on seed 1 of the scenes both ran on.
struct Difference {
  double preservation = 0.0, rejection = 0.0, f1 = 0.0, iou = 0.0, milliseconds = 0.0;
  /// The scene whose F1 differs most, and by how much.
  std::string mostChanged;
  double mostChange = 0.0;
};
Difference differenceToDefault(const std::vector<CaseResult>& results, const std::string& variant);

}  // namespace toss
