// SPDX-License-Identifier: BSD-3-Clause
#include "LabelSurvey.h"

#include <toss/rawlog/LabelFile.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "LabelledScans.h"

namespace fs = std::filesystem;

namespace toss {
namespace {

/// Indices of the scored label files of a folder, ascending.
std::vector<std::uint64_t> scoredLabelFiles(const fs::path& folder,
                                            const EvaluationOptions& options) {
  std::vector<std::uint64_t> indices;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    std::uint64_t index = 0;
    const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), index);
    const bool number = error == std::errc() && end == stem.data() + stem.size();
    if (number && entry.path() == labelPath(folder, index) && isScored(index, options)) {
      indices.push_back(index);
    }
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

std::vector<std::uint32_t> readWholeFile(const fs::path& file) {
  return readLabels(file, static_cast<std::size_t>(fs::file_size(file)) / sizeof(std::uint32_t));
}

std::uint64_t countClassZero(const std::vector<std::uint32_t>& labels) {
  return static_cast<std::uint64_t>(
      std::count_if(labels.begin(), labels.end(),
                    [](std::uint32_t value) { return label::semantic(value) == 0; }));
}

bool ignores(const EvaluationOptions& options, const LabelSurvey& survey) {
  if (options.unlabelled != Unlabelled::Auto) return options.unlabelled == Unlabelled::Ignore;
  return 2 * survey.trueUnlabelled > survey.trueLabels;
}

}  // namespace

LabelSurvey surveyLabels(const fs::path& trueLabels, const fs::path& runLabels,
                         const EvaluationOptions& options) {
  LabelSurvey survey;
  const std::vector<std::uint64_t> indices = scoredLabelFiles(trueLabels, options);
  for (const std::uint64_t index : indices) {
    const std::vector<std::uint32_t> truth = readWholeFile(labelPath(trueLabels, index));
    survey.trueLabels += truth.size();
    survey.trueUnlabelled += countClassZero(truth);
  }
  survey.ignoreUnlabelled = ignores(options, survey);
  if (runLabels.empty()) return survey;
  for (const std::uint64_t index : indices) {
    if (!fs::exists(labelPath(runLabels, index))) continue;
    std::vector<std::uint32_t> truth = readWholeFile(labelPath(trueLabels, index));
    applyClassOptions(options, truth);
    const std::vector<std::uint32_t> run = readLabels(labelPath(runLabels, index), truth.size());
    survey.runLabels += run.size();
    survey.runInvalid += countClassZero(run);
    survey.traces.add(truth, run, survey.ignoreUnlabelled);
  }
  return survey;
}

}  // namespace toss
