// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/SensorModel.h>

#include <string>

#include "MapRun.h"

namespace toss {

/// The sensor of a run.
struct SensorChoice {
  SensorModel model;
  /// Name of the preset that goes with it, "" where there is none.
  std::string preset;
  /// What section [sensor] says of it: a known name, or "auto" for a sensor measured from the data.
  std::string name;
};

/// The sensor that the configuration names, else the one that the first scan looks like, else one
/// with the beams that the first scan shows.
SensorChoice chooseSensor(const MapRequest& request, const RunConfiguration& configuration);

}  // namespace toss
