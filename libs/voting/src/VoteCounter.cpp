// SPDX-License-Identifier: BSD-3-Clause
#include "VoteCounter.h"

#include <algorithm>

namespace toss {

namespace {

/// The first voter of [first, last), sorted by time, for which `isEarly(time)` is false.
template <typename IsEarly>
const Voter* firstNot(const Voter* first, const Voter* last, IsEarly&& isEarly) {
  return std::partition_point(first, last,
                              [&isEarly](const Voter& voter) { return isEarly(voter.time); });
}

}  // namespace

int VoteCounter::countDynamic(const Voter& voted) {
  tally_.start();
  const double t = voted.time, adjacent = rules_.adjacent();
  grid_.visit(voted.center, rules_.reach(voted), [&](const VoterCell& cell) {
    if (cell.dynamicVoters == 0) return;
    const Voter* const end =
        firstNot(cell.begin(), cell.end(), [=](double time) { return time - t <= adjacent; });
    for (const Voter* v = end; v != cell.begin() && t - (v - 1)->time <= adjacent;) {
      --v;
      if (rules_.votesDynamic(voted, *v, traces_.motion(v->trace))) tally_.add(v->scan);
    }
  });
  return tally_.count();
}

int VoteCounter::countStatic(const Voter& voted, int limit) {
  tally_.start();
  const double t = voted.time, distant = rules_.distant(), horizon = rules_.horizon();
  grid_.visit(voted.center, rules_.reach(voted), [&](const VoterCell& cell) {
    const Voter* const begin =
        firstNot(cell.begin(), cell.end(), [=](double time) { return t - time > horizon; });
    const Voter* const gapBegin =
        firstNot(begin, cell.end(), [=](double time) { return t - time >= distant; });
    const Voter* const gapEnd =
        firstNot(gapBegin, cell.end(), [=](double time) { return time - t < distant; });
    const Voter* const end =
        firstNot(gapEnd, cell.end(), [=](double time) { return time - t <= horizon; });
    countStatic(voted, begin, gapBegin, limit);
    countStatic(voted, gapEnd, end, limit);
  });
  return tally_.count();
}

void VoteCounter::countStatic(const Voter& voted, const Voter* first, const Voter* last,
                              int limit) {
  for (const Voter* v = last; v != first && tally_.count() < limit;) {
    --v;
    if (!tally_.has(v->scan) && rules_.votesStatic(voted, *v, traces_.motion(v->trace))) {
      tally_.add(v->scan);
    }
  }
}

}  // namespace toss
