// SPDX-License-Identifier: BSD-3-Clause
#include <toss/voting/DecisionOptions.h>

namespace toss {

void DecisionOptions::visit(OptionVisitor& v) {
  v.real({"free_share", "", "An instance moves if this share of it is seen through", "spec 12"},
         freeShare, 0.0, 1.0);
  v.real({"trace_free_share", "", "A trace moves if this share of it is seen through", "spec 12"},
         traceFreeShare, 0.0, 1.0);
  v.real({"confirm_free_share", "", "A trace that moved weakly is strong from this share on",
          "spec 12"},
         confirmFreeShare, 0.0, 1.0);
  v.real({"live_free_share", "", "The same for live labels, from past views alone", "spec 12"},
         liveFreeShare, 0.0, 1.0);
  v.real({"veto_hit_share", "", "A trace stays if at least this share of it is measured again",
          "spec 12"},
         vetoHitShare, 0.0, 1.0);
  v.real({"veto_free_share", "", "and less than this share of it is seen through", "spec 12"},
         vetoFreeShare, 0.0, 1.0);
  v.real({"doubtful_glimpsed_share", "",
          "A trace whose motion is doubtful moves if this share of it is glimpsed past",
          "measured on simulated scans"},
         doubtfulGlimpsedShare, 0.0, 1.0);
  v.integer(
      {"min_cells", "", "Cells that must be seen through for the free share to count", "spec 12"},
      minCells, 1, 100);
  v.integer(
      {"lone_free_views", "", "Free views that make a return without an instance move", "spec 12"},
      loneFreeViews, 1, 100);
  v.flag({"claims", "", "Whether boxes of moving traces claim returns beyond their instances",
          "spec 10"},
         claims);
  v.integer({"claim_scans", "", "Scans that must have seen a trace for it to claim",
             "measured on simulated scans"},
            claimScans, 1, 1000);
  v.real({"claim_free_share", "", "or the share of it that must be seen through",
          "measured on simulated scans"},
         claimFreeShare, 0.0, 1.0);
  v.real(
      {"residue_margin", "m",
       "Returns in a moving trace's box grown by this move where nothing static was measured too",
       "spec 11.1"},
      residueMargin, 0.0, 1.0);
  v.real({"residue_place", "m",
          "Size of the place in which nothing static may have been measured, 0 = they move anyway",
          "measured on simulated scans"},
         residuePlace, 0.0, 1.0);
  v.real({"hindsight_time", "s",
          "Time before it was first seen in which a moving trace takes what lies on its way",
          "spec 10.2"},
         hindsightTime, 0.0, 5.0);
}

}  // namespace toss
