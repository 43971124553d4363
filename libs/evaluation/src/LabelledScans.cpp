// SPDX-License-Identifier: BSD-3-Clause
#include "LabelledScans.h"

#include <toss/geometry/Error.h>
#include <toss/rawlog/InputOptions.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/LidarSelection.h>

namespace toss {
namespace {

constexpr std::uint32_t kMovingTruck = 258;

std::filesystem::path trueLabelsOf(const std::filesystem::path& truth) {
  if (!std::filesystem::exists(truth)) {
    throw UserError(truth.string(), "there is no such file or folder",
                    "give a KITTI folder with labels/ or a rawlog with <stem>_labels/ beside it");
  }
  std::filesystem::path folder = labelsFolderOf(truth);
  if (folder.empty()) {
    throw UserError(truth.string(), "has no true labels",
                    "put labels/ into the folder, or <stem>_labels/ beside the rawlog");
  }
  return folder;
}

}  // namespace

bool isScored(std::uint64_t index, const EvaluationOptions& options) {
  const auto i = static_cast<std::int64_t>(index);
  if (i < options.from || (options.to >= 0 && i > options.to)) return false;
  return (i - options.from) % options.stride == 0;
}

void applyClassOptions(const EvaluationOptions& options, std::vector<std::uint32_t>& labels) {
  if (!options.omitTruckClass) return;
  for (std::uint32_t& value : labels) {
    if (label::semantic(value) == kMovingTruck) value = value - kMovingTruck + label::kStatic;
  }
}

LabelledScans::LabelledScans(const std::filesystem::path& truth,
                             const std::filesystem::path& runLabels,
                             const EvaluationOptions& options, const InputOptions& input)
    : options_(options),
      trueLabels_(trueLabelsOf(truth)),
      runLabels_(runLabels),
      source_(openScans(truth, withSelectedLidars(truth, input))) {}

bool LabelledScans::hasLabels(std::uint64_t index) {
  if (!std::filesystem::exists(labelPath(trueLabels_, index))) return ++withoutTruth_, false;
  if (runLabels_.empty() || std::filesystem::exists(labelPath(runLabels_, index))) return true;
  return ++withoutRunLabels_, false;
}

bool LabelledScans::next(PosedScan& scan, std::vector<std::uint32_t>& labels) {
  while (source_->next(scan)) {
    if (!isScored(scan.index, options_) || !hasLabels(scan.index)) continue;
    labels = readLabels(labelPath(trueLabels_, scan.index), scan.points.size());
    applyClassOptions(options_, labels);
    return true;
  }
  return false;
}

}  // namespace toss
