// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

#include "Command.h"
#include "RunConfiguration.h"

namespace toss {

/// What `toss map` is asked to do.
struct MapRequest {
  std::filesystem::path input, output;
  ConfigurationRequest configuration;
  /// First and last scan that are used, by their number in the input, both included.
  std::uint64_t from = 0, to = std::numeric_limits<std::uint64_t>::max();
  /// Threads of the whole program; 0 = all cores.
  int threads = 0;
  bool snapshots = true, liveLabels = false, instances = false;
  /// Whether the poses are found from the scans: see LidarOdometry.
  bool odometry = false;
};

/// Name of the input without the folders it lies in.
std::string inputName(const MapRequest& request);

/// Maps the input and leaves all outputs in request.output, summary.json last. A run that fails
/// before all scans are mapped leaves the folder as it was. Throws UserError.
void runMap(const MapRequest& request, const Verbosity& verbosity);

}  // namespace toss
