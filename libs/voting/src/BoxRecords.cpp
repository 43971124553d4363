// SPDX-License-Identifier: BSD-3-Clause
#include "BoxRecords.h"

#include <stdexcept>
#include <string>

namespace toss {

const BoxRecord& BoxRecords::known(BoxId box) const {
  if (!has(box) || records_[box - firstId_].released) {
    throw std::logic_error("DsVoting: box " + std::to_string(box) + " is unknown or released");
  }
  return records_[box - firstId_];
}

void BoxRecords::closeBefore(double time) {
  while (openScan_ < scans_.size() && scans_[openScan_].time < time) ++openScan_;
  firstOpen_ = openScan_ < scans_.size() ? scans_[openScan_].firstBox : nextId();
}

void BoxRecords::giveUpReleased() {
  while (firstId_ < firstVoter_ && records_.front().released) {
    records_.pop_front();
    ++firstId_;
  }
}

}  // namespace toss
