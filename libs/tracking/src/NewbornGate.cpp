// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/NewbornGate.h>

#include <algorithm>

namespace toss {

double newbornReach(const NewbornOptions& options, double seconds) {
  return options.base + options.maxSpeed * std::min(seconds, options.maxTime);
}

double confirmationReach(const NewbornOptions& options, double step) {
  return options.confirmBase + options.confirmFactor * step;
}

}  // namespace toss
