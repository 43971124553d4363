// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/EvaluationOptions.h>
#include <toss/rawlog/ScanSource.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace toss {

/// Whether a scan of that index is scored, by from, to and stride.
bool isScored(std::uint64_t index, const EvaluationOptions& options);

/// True labels with the class that counts: 258 becomes static where it is to be omitted.
void applyClassOptions(const EvaluationOptions& options, std::vector<std::uint32_t>& labels);

/// The scored scans of an input with their true labels, one at a time.
class LabelledScans {
 public:
  /// `runLabels`: folder that must hold labels for a scan too, "" if none must. Throws UserError
  /// where the input has no true labels.
  LabelledScans(const std::filesystem::path& truth, const std::filesystem::path& runLabels,
                const EvaluationOptions& options, const InputOptions& input);

  /// Reads the next scored scan; false at the end.
  bool next(PosedScan& scan, std::vector<std::uint32_t>& labels);
  double progress() const { return source_->progress(); }
  std::uint64_t withoutTruth() const { return withoutTruth_; }
  std::uint64_t withoutRunLabels() const { return withoutRunLabels_; }

 private:
  bool hasLabels(std::uint64_t index);

  const EvaluationOptions& options_;
  std::filesystem::path trueLabels_, runLabels_;
  std::unique_ptr<ScanSource> source_;
  std::uint64_t withoutTruth_ = 0, withoutRunLabels_ = 0;
};

}  // namespace toss
