// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>

#include <filesystem>

namespace toss {

/// One .sweep file (SweepFolder.h): rings, times and `motionCompensated` of a scan.
/// Throws UserError if it can't be written.
void writeSweep(const std::filesystem::path& file, const PosedScan& scan);

/// Replaces those of `scan`, whose points are there. Throws UserError where the file can't be read,
/// is damaged, or has another number of points.
void readSweep(const std::filesystem::path& file, PosedScan& scan);

}  // namespace toss
