// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/voting/DecisionOptions.h>

#include <string>

namespace toss {

/// What to do in doubt, the one choice that trades preservation (PR) for rejection (RR).
enum class Keep {
  Static,    ///< keep: nothing that stays may be lost, such as for localization against the map
  Balanced,  ///< the defaults
  Remove     ///< remove: nothing that moves may stay, such as for planning in the map
};

/// From "static", "balanced" or "remove"; throws UserError for other names.
Keep keepFromName(const std::string& name);

/// Sets the thresholds of the verdict to what `keep` asks for; Balanced leaves them as they are.
void leanTowards(Keep keep, DecisionOptions& decision);

}  // namespace toss
