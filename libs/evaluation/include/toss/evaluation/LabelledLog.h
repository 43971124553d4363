// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/rawlog/InputOptions.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace toss {

/// A log with its true labels, held in memory so that many configurations can be run on it.
struct LabelledLog {
  /// Name for tables.
  std::string name;
  /// Name of the sensor model, one of knownSensors().
  std::string sensor;
  /// In order of time.
  std::vector<PosedScan> scans;
  /// True labels of each scan: low 16 bits class, high 16 bits instance, shape [scans][points].
  std::vector<std::vector<std::uint32_t>> labels;
};

/// Which scans of an input are taken: every `stride`-th of those numbered `from` to `to`, both
/// included.
struct ScanChoice {
  std::uint64_t from = 0, to = std::numeric_limits<std::uint64_t>::max(), stride = 1;
};

/// Reads the chosen scans that have a label file. Throws UserError where the input has no labels,
/// where they do not fit, where no scan is chosen, and where the sensor is unknown.
LabelledLog readLabelledLog(const std::filesystem::path& input, const ScanChoice& choice,
                            const InputOptions& options);

}  // namespace toss
