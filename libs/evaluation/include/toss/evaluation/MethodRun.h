// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/LabelledLog.h>
#include <toss/mapping/VoxelMap.h>
#include <toss/pipeline/PipelineOptions.h>
#include <toss/pipeline/ScanLabels.h>
#include <toss/segmentation/Segmentation.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace toss {

/// What a method says of one scan; labels as `toss map` writes them, shape [points] each.
struct ScanAnswer {
  /// Final labels. High 16 bits: trace.
  std::vector<std::uint32_t> final;
  /// Called moving with no look-ahead; empty where the method has no such answer.
  std::vector<bool> liveMoving;
  /// Low 16 bits PointClass, high 16 bits instance; empty where the method has no instances.
  std::vector<std::uint32_t> instances;
};

/// A method's answers for a whole log.
struct MethodRun {
  /// Shape [scans].
  std::vector<ScanAnswer> answers;
  /// Time spent on each scan [ms], shape [scans]: with an equal share of what is left to do at the
  /// end of the log, the stage "rest".
  std::vector<double> milliseconds;
  /// The same by stage, in the order of the stages, for methods that have stages.
  std::vector<std::pair<std::string, std::vector<double>>> stages;
  /// Every trace in each scan, shape [scans][traces]: for pictures.
  std::vector<std::vector<TrackSample>> tracks;
};

/// Number of a trace in label files, which have 16 bits for it: 1 .. 65535, used again from 1 on
/// after them; 0 = none. Traces of one time are told apart all the same; tracks.csv has the full
/// numbers.
constexpr std::uint32_t toFileTrack(std::uint32_t track) {
  return track == 0 ? 0 : (track - 1) % 65535 + 1;
}

/// Labels of a scan in the words of the label files: class in the low 16 bits, toFileTrack() in the
/// high ones.
std::vector<std::uint32_t> toFileLabels(const ScanLabels& labels);
/// The same for segmentation: PointClass in the low 16 bits, instance in the high ones.
std::vector<std::uint32_t> toFileLabels(const Segmentation& segmentation);

/// Runs TOSS on the log, in this thread.
MethodRun runPipeline(const LabelledLog& log, const PipelineOptions& options);

/// The map that nobody cleans: every return stays.
MethodRun keepEverything(const LabelledLog& log);

}  // namespace toss
