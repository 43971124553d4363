// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/ScanSource.h>

#include "KittiFolder.h"
#include "ScanBookkeeping.h"

namespace toss {

/// The scans of a folder in KITTI layout.
class KittiFolderSource : public ScanSource {
 public:
  KittiFolderSource(const std::filesystem::path& folder, const InputOptions& options);

  bool next(PosedScan& scan) override;
  double progress() const override;
  std::uint64_t scanCount() const override { return folder_.scans.size(); }
  const InputReport& report() const override { return report_; }

 private:
  KittiFolder folder_;
  std::size_t next_ = 0;
  SensorMemory sensor_;
  InputReport report_;
};

}  // namespace toss
