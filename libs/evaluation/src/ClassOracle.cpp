// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/ClassOracle.h>
#include <toss/rawlog/LabelFile.h>

namespace toss {

ClassOracle::ClassOracle() : balance_(65536, 0) {}

void ClassOracle::clear() {
  balance_.assign(balance_.size(), 0);
}

void ClassOracle::add(const std::vector<std::uint32_t>& truth,
                      const std::vector<std::uint32_t>& grouped, bool ignoreUnlabelled) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (ignoreUnlabelled && label::semantic(truth[i]) == 0) continue;
    balance_[label::instance(grouped[i])] += label::isMoving(truth[i]) ? 1 : -1;
  }
}

bool ClassOracle::moving(std::uint32_t group) const {
  return group != 0 && balance_[group] > 0;
}

}  // namespace toss
