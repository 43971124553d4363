// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "OctoMapBaseline.h"

namespace toss {

bool hasOctoMap() {
  return false;
}

MethodRun runOctoMap(const LabelledLog&) {
  throw std::logic_error("built without OctoMap");
}

}  // namespace toss
