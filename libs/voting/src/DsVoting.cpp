// SPDX-License-Identifier: BSD-3-Clause
#include <toss/voting/DsVoting.h>

#include "OnlineVoting.h"

namespace toss {

struct DsVoting::Implementation : OnlineVoting {
  using OnlineVoting::OnlineVoting;
};

DsVoting::DsVoting(const VotingOptions& options)
    : implementation_(std::make_unique<Implementation>(options)) {}

DsVoting::~DsVoting() = default;

BoxId DsVoting::addScan(const std::vector<VotingBox>& boxes) {
  return implementation_->addScan(boxes);
}

void DsVoting::setTrackClass(TrackId track, MotionClass motion) {
  implementation_->setTrackClass(track, motion);
}

bool DsVoting::isDynamic(BoxId box) const {
  return implementation_->isDynamic(box);
}

DsVoting::Votes DsVoting::votes(BoxId box) const {
  return implementation_->votes(box);
}

std::vector<BoxId> DsVoting::takeChanges() {
  return implementation_->takeChanges();
}

void DsVoting::release(BoxId box) {
  implementation_->release(box);
}

void DsVoting::forgetBefore(double time) {
  implementation_->forgetBefore(time);
}

}  // namespace toss
