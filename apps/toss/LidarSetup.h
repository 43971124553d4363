// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/LidarSelection.h>
#include <toss/rawlog/SensorChoice.h>

#include <filesystem>
#include <string>
#include <vector>

#include "RunConfiguration.h"

namespace toss {

/// A LiDAR of a run: its label, beams, and the options that go with it.
struct LidarSetup {
  /// "" where the input has one LiDAR.
  std::string label;
  SensorChoice sensor;
  RunConfiguration configuration;
};

/// The LiDARs of `selection`, each with the preset of its model; for an input with one, that one as
/// sensorOfInput() finds it. `input`: how the input is read. Throws UserError where a LiDAR has no
/// scan with returns.
std::vector<LidarSetup> setUpLidars(const std::filesystem::path& path,
                                    const ConfigurationRequest& request,
                                    const LidarSelection& selection, const InputOptions& input,
                                    std::uint64_t from, std::uint64_t to);

/// config.ini of a run with several LiDARs: what their presets make different is left out, and
/// sensor.model is auto, so that reading it back gives each LiDAR its own again.
std::string configurationText(std::vector<LidarSetup>& lidars);

}  // namespace toss
