// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>
#include <toss/geometry/PosedScan.h>
#include <toss/geometry/SensorModel.h>

#include <string>

namespace toss {

/// Which sensor the scans come from, section [sensor].
struct SensorOptions : Options {
  /// Name of a known model, or "auto": found out from the input.
  std::string model = "auto";

  const char* section() const override { return "sensor"; }
  void visit(OptionVisitor& visitor) override;
};

/// The sensor of a run.
struct SensorChoice {
  SensorModel model;
  /// Name of the preset that goes with it (SensorPresets.h), "" where there is none.
  std::string preset;
  /// What section [sensor] says of it: a known name, or "auto" for a sensor measured from the data.
  std::string name;
};

/// The sensor that the scan looks like, else one with the beams that it shows. `scan`: the first
/// one that has returns.
SensorChoice chooseSensor(const PosedScan& scan);

}  // namespace toss
