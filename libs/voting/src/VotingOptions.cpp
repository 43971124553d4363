// SPDX-License-Identifier: BSD-3-Clause
#include <toss/voting/VotingOptions.h>

namespace toss {

void VotingOptions::visit(OptionVisitor& visitor) {
  visitor.choice({"mode", "", "Reading of the paper's vote; guarded has the fewest known failures",
                  "spec 7.3"},
                 mode, {"off", "literal", "dynamic_only", "classwise", "guarded"});
  visitor.choice({"empty_vote", "",
                  "What a box without any vote becomes; by_mode: dynamic in literal and classwise, "
                  "else the class of its trace",
                  "spec 7.3, ambiguity 35"},
                 emptyVote, {"by_mode", "coarse", "dynamic"});
  visitor.real({"tau", "m", "Mode literal: voters nearer than this vote", "spec 7.3"}, tau, 0.01,
               10.0);
  visitor.real({"tau_scale", "",
                "Other modes: tau over the longer edge of the voted box; larger "
                "lets more voters in",
                "spec 7.3"},
               tauScale, 0.0, 5.0);
  visitor.real({"tau_min", "m", "Smallest tau", "spec 7.3"}, tauMin, 0.01, 10.0);
  visitor.real({"tau_max", "m", "Largest tau", "spec 7.3"}, tauMax, 0.01, 10.0);
  visitor.real(
      {"tau_drift_per_s", "m/s",
       "Growth of tau with the time between box and voter, up to twice tau; for poses that "
       "drift",
       "ambiguity 47"},
      tauDriftPerSecond, 0.0, 1.0);
  visitor.real({"tau_d", "s", "Voters at most this far away in time vote for dynamic", "spec 7.3"},
               tauD, 0.0, 10.0);
  visitor.real({"tau_s", "s", "Voters at least this far away in time vote for static; above tau_d",
                "spec 7.3"},
               tauS, 0.0, 60.0);
  visitor.real({"horizon", "s", "Voters farther away in time do not vote; 0 = no limit",
                "spec 7.3, ambiguity 37"},
               horizon, 0.0, 36000.0);
  visitor.real({"v_slow", "m/s",
                "Guarded: boxes of other weak traces slower than this count as "
                "static evidence",
                "spec 7.3"},
               slowSpeed, 0.0, 10.0);
  visitor.real({"v_move", "m/s",
                "Guarded: boxes of other dynamic traces vote for dynamic from this "
                "speed on",
                "spec 7.3"},
               movingSpeed, 0.0, 10.0);
  visitor.real({"size_compatibility", "",
                "Guarded: smaller over larger volume that foreign static "
                "evidence needs; larger admits less",
                "ambiguity 38"},
               sizeCompatibility, 0.0, 1.0);
  visitor.real({"dynamic_size_compatibility", "", "Guarded: the same for foreign votes for dynamic",
                "spec 7.5"},
               dynamicSizeCompatibility, 0.0, 1.0);
}

void VotingOptions::checkAll() const {
  check();
  if (!(tauS > tauD)) {
    throw UserError("voting.tau_s", "is not greater than voting.tau_d",
                    "else an object's own slow passage votes against it; raise tau_s");
  }
  if (tauMax < tauMin) {
    throw UserError("voting.tau_max", "is smaller than voting.tau_min", "raise it");
  }
  if (horizon > 0.0 && horizon < tauS) {
    throw UserError("voting.horizon", "is shorter than voting.tau_s",
                    "raise it, or set it to 0 for no limit");
  }
}

}  // namespace toss
