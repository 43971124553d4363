// SPDX-License-Identifier: BSD-3-Clause
#include "ScanRange.h"

#include <algorithm>

namespace toss {

ScanRange::ScanRange(const std::filesystem::path& input, const InputOptions& options,
                     std::uint64_t from, std::uint64_t to)
    : source_(openScans(input, options)), from_(from), to_(to), last_(from) {
  const std::uint64_t count = source_->scanCount();
  const std::string where = "--from " + std::to_string(from);
  if (from > to)
    throw UserError(where, "it lies behind --to " + std::to_string(to),
                    "give a range that holds a scan");
  if (count > 0 && from >= count)
    throw UserError(where, "the input holds scans 0 to " + std::to_string(count - 1),
                    "give a range that holds a scan");
}

bool ScanRange::next(PosedScan& scan) {
  while (source_->next(scan)) {
    if (scan.index > to_) return false;
    last_ = scan.index;
    if (scan.index >= from_) return true;
  }
  return false;
}

double ScanRange::progress() const {
  const std::uint64_t count = source_->scanCount();
  if (count == 0) return source_->progress();
  const std::uint64_t end = std::min(to_, count - 1);
  return static_cast<double>(last_ + 1 - from_) / static_cast<double>(end + 1 - from_);
}

}  // namespace toss
