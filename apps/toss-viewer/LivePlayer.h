// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/pipeline/Pipeline.h>

#include <memory>

#include "FlipWatch.h"
#include "RunConfiguration.h"
#include "ScanRange.h"

namespace toss {

/// What is played.
struct PlayRequest {
  std::filesystem::path input;
  ConfigurationRequest configuration;
  /// First and last scan, by their number in the input, both included.
  std::uint64_t from = 0, to = std::numeric_limits<std::uint64_t>::max();
  /// The map is renewed after so many scans.
  int mapPeriod = 10;
};

/// Plays a log through the method, scan by scan.
class LivePlayer {
 public:
  /// Throws UserError where the input or the configuration is wrong.
  explicit LivePlayer(const PlayRequest& request);

  /// The next scan and what is known after it; false at the end. Throws UserError for damaged
  /// inputs.
  bool next(LiveFrame& frame);
  double progress() const { return scans_->progress(); }
  /// Name of the input, for titles.
  const std::string& name() const { return name_; }

 private:
  void show(const ScanLabels& labels, LiveFrame& frame) const;

  std::string name_;
  int mapPeriod_;
  std::unique_ptr<ScanRange> scans_;
  std::unique_ptr<Pipeline> pipeline_;
  PosedScan scan_;
  FlipWatch watch_;
  std::uint64_t count_ = 0;
  double firstTime_ = 0.0;
};

}  // namespace toss
