// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// How the paper's vote is read (spec section 7.3, readings R1 to R5).
enum class VotingMode {
  Off,          ///< no vote: a box has the coarse class of its trace
  Literal,      ///< R1: every traced box votes both ways, the formula as it is printed
  DynamicOnly,  ///< R2: boxes of dynamic traces alone vote, both ways
  Classwise,    ///< R3: dynamic traces vote for dynamic, static traces for static
  Guarded       ///< R5 with the strong veto: classwise, and see the options below
};

/// What a box becomes that no vote was cast on, where the paper's rule says dynamic (0 = 0).
enum class EmptyVote {
  ByMode,  ///< Literal and Classwise: Dynamic; DynamicOnly and Guarded: Coarse
  Coarse,  ///< the coarse class of its trace
  Dynamic  ///< dynamic, as printed
};

/// Options of DS-Voting, section [voting] (spec section 7).
struct VotingOptions : Options {
  VotingMode mode = VotingMode::Guarded;
  EmptyVote emptyVote = EmptyVote::ByMode;
  /// tau of the paper in mode Literal [m].
  double tau = 1.0;
  /// tau in the other modes: tauScale times the longer edge of the voted box, within
  /// [tauMin, tauMax] [m].
  double tauScale = 0.5, tauMin = 0.5, tauMax = 1.5;
  /// Growth of tau with the time between box and voter, for drifting poses [m/s]; up to twice tau.
  double tauDriftPerSecond = 0.0;
  /// tau_d: voters at most this far away in time vote for dynamic [s].
  double tauD = 0.5;
  /// tau_s: voters at least this far away in time vote for static [s]; greater than tauD.
  double tauS = 2.0;
  /// Voters farther away in time than this do not vote [s]; 0 = no limit.
  double horizon = 60.0;
  /// Guarded: boxes of other weak traces count as static evidence while slower than this [m/s].
  double slowSpeed = 1.0;
  /// Guarded: boxes of other dynamic traces vote for dynamic while at least this fast [m/s].
  double movingSpeed = 0.5;
  /// Guarded: smaller over larger volume that foreign static evidence needs; 0 = any size.
  double sizeCompatibility = 0.3;
  /// Guarded: the same for foreign votes for dynamic; 0 = any size.
  double dynamicSizeCompatibility = 0.0;

  const char* section() const override { return "voting"; }
  void visit(OptionVisitor& visitor) override;
  /// Options::check(), and that tauS > tauD, tauMax >= tauMin, and the horizon holds tauS.
  void checkAll() const;
};

}  // namespace toss
