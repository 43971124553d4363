// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/ScanSource.h>

#include <memory>

namespace toss {

/// The scans of an input from one number to another, both included.
class ScanRange {
 public:
  ScanRange(const std::filesystem::path& input, const InputOptions& options, std::uint64_t from,
            std::uint64_t to);

  /// As ScanSource::next.
  bool next(PosedScan& scan);
  /// Share of the range that has been read, 0 to 1, as far as the input tells.
  double progress() const;
  const InputReport& report() const { return source_->report(); }

 private:
  std::unique_ptr<ScanSource> source_;
  std::uint64_t from_, to_, last_ = 0;
};

}  // namespace toss
