// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace toss {

/// Numbers of a scan's owners that claim returns: claims have the same one if they are alike in the
/// box that claims and in the instance out of which it does. Most boxes claim out of one instance
/// or none, so the owners of each stand in a short list.
class ClaimingOwners {
 public:
  struct Numbered {
    std::int32_t owner;
    bool isNew;
  };

  /// Begins a scan with as many boxes; its owners that claim are numbered from `first` on.
  void start(std::size_t claimants, std::size_t first) {
    firstOf_.assign(claimants, kNone);
    owners_.clear();
    first_ = static_cast<std::int32_t>(first);
  }
  /// The owner of what a box claims out of instance `host`, 0 = none; numbered anew where there is
  /// none yet.
  Numbered ownerOf(std::int32_t claimant, std::int32_t host) {
    std::int32_t* next = &firstOf_[static_cast<std::size_t>(claimant)];
    while (*next != kNone) {
      Owner& owner = owners_[static_cast<std::size_t>(*next)];
      if (owner.host == host) return {first_ + *next, false};
      next = &owner.next;
    }
    *next = static_cast<std::int32_t>(owners_.size());
    owners_.push_back({host, kNone});
    return {first_ + static_cast<std::int32_t>(owners_.size()) - 1, true};
  }

 private:
  static constexpr std::int32_t kNone = -1;
  struct Owner {
    std::int32_t host;
    /// Another of the same box.
    std::int32_t next;
  };

  /// The first owner of each box.
  std::vector<std::int32_t> firstOf_;
  std::vector<Owner> owners_;
  std::int32_t first_ = 0;
};

}  // namespace toss
