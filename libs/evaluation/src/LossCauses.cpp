// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/LossCauses.h>
#include <toss/rawlog/LabelFile.h>

#include <algorithm>

namespace toss {
namespace {

constexpr std::array<std::uint64_t, kReturnSteps - 1> kReturnStepEnds = {3, 5, 10, 50};

template <typename Counts>
void add(Counts& counts, int place, bool right) {
  VoxelCounts& entry = counts.at(static_cast<std::size_t>(place));
  ++entry.voxels, entry.right += right;
}

}  // namespace

const char* lossCauseName(LossCause cause) {
  switch (cause) {
    case LossCause::Classification:
      return "called static";
    case LossCause::Ground:
      return "labelled ground";
    case LossCause::Merged:
      return "merged into a static instance";
    case LossCause::NoInstance:
      return "no instance, object of 10 returns or more";
    case LossCause::NoInstanceSmall:
      return "no instance, object under 10 returns";
    case LossCause::Invalid:
      break;
  }
  return "out of range or invalid";
}

int returnStep(std::uint64_t returns) {
  return static_cast<int>(
      std::upper_bound(kReturnStepEnds.begin(), kReturnStepEnds.end(), returns) -
      kReturnStepEnds.begin());
}

const char* returnStepName(int step) {
  static constexpr std::array<const char*, kReturnSteps> names = {"under 3", "3-4", "5-9", "10-49",
                                                                  "50 and more"};
  return names.at(static_cast<std::size_t>(step));
}

std::uint32_t packFacts(std::uint32_t trueClass, const ReturnFacts& facts) {
  return label::semantic(trueClass) | static_cast<std::uint32_t>(facts.band) << 16 |
         static_cast<std::uint32_t>(facts.returns) << 18 |
         static_cast<std::uint32_t>(facts.cause) << 21;
}

ReturnFacts unpackFacts(std::uint32_t label) {
  return {static_cast<int>(label >> 16 & 3u), static_cast<int>(label >> 18 & 7u),
          static_cast<LossCause>(label >> 21 & 7u)};
}

LossTable lossTable(const LabelledCloud& truth, const LabelledCloud& estimate,
                    const MapComparison& comparison) {
  LossTable table;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const ReturnFacts facts = unpackFacts(truth.label[i]);
    const VoxelFate fate = comparison.fate[i];
    if (fate == VoxelFate::Kept || fate == VoxelFate::Lost) {
      add(table.staticByRange, facts.band, fate == VoxelFate::Kept);
      continue;
    }
    add(table.movingByRange, facts.band, fate == VoxelFate::Removed);
    add(table.movingByReturns, facts.returns, fate == VoxelFate::Removed);
    if (fate == VoxelFate::Removed) continue;
    const auto left = static_cast<std::size_t>(comparison.nearest[i]);
    ++table.residueByCause.at(static_cast<std::size_t>(unpackFacts(estimate.label[left]).cause));
  }
  return table;
}

}  // namespace toss
