// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "VoterGrid.h"

namespace toss {

/// What is known about one box beyond what it votes with.
struct BoxRecord {
  VoterGrid::CellIndex cell = 0;
  /// Votes so far, up to date while the box is dynamic.
  DsVoting::Votes votes;
  /// Last scan that voted for dynamic, and for static.
  std::int32_t lastDynamicScan = -1, lastStaticScan = -1;
  bool dynamic = false;
  /// Label at the last takeChanges().
  bool reported = false;
  bool released = false;
  /// Waits for votes for static in its cell's list.
  bool pending = false;
  /// Waits to be judged anew at the end of the scan.
  bool dirty = false;
};

/// The records of the boxes by id, and the scans they came with.
class BoxRecords {
 public:
  /// Starts a scan; the boxes that are added after it are its own.
  void startScan(double time) { scans_.push_back({time, nextId()}); }
  BoxId add(const BoxRecord& record) {
    records_.push_back(record);
    return nextId() - 1;
  }
  BoxId nextId() const { return firstId_ + records_.size(); }
  BoxRecord& operator[](BoxId box) { return records_[box - firstId_]; }
  /// The record of a box that was neither released nor given up; std::logic_error for others.
  const BoxRecord& known(BoxId box) const;
  bool has(BoxId box) const { return box >= firstId_ && box < nextId(); }

  /// Whether the label of the box may still change.
  bool isOpen(BoxId box) const { return box >= firstOpen_ && !records_[box - firstId_].released; }
  /// Closes all boxes of scans before `time` [s].
  void closeBefore(double time);
  /// Calls `remove(BoxId)` for the voters of all scans before `time` [s], in order.
  template <typename Remove>
  void removeVotersBefore(double time, Remove&& remove) {
    while (!scans_.empty() && scans_.front().time < time) {
      const BoxId end = scans_.size() > 1 ? scans_[1].firstBox : nextId();
      for (; firstVoter_ < end; ++firstVoter_) remove(firstVoter_);
      scans_.pop_front();
      if (openScan_ > 0) --openScan_;
    }
    giveUpReleased();
  }

 private:
  struct Scan {
    double time;
    BoxId firstBox;
  };
  void giveUpReleased();

  std::deque<BoxRecord> records_;
  std::deque<Scan> scans_;
  /// Id of records_[0], of the first box that is open, and of the first that votes.
  BoxId firstId_ = 0, firstOpen_ = 0, firstVoter_ = 0;
  /// Place in scans_ of the first scan that is not closed.
  std::size_t openScan_ = 0;
};

}  // namespace toss
