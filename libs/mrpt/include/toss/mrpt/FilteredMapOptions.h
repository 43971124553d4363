// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <toss/pipeline/PipelineOptions.h>
#include <toss/rawlog/SensorChoice.h>

#include <string>
#include <vector>

namespace toss {

/// How the plug-in takes observations and shows its map, section [plugin].
struct PlugInOptions : Options {
  /// Label of the sensor whose scans are taken; "" = all LiDARs. Scans of others are
  /// refused.
  std::string sensorLabel;
  /// The rawlog that is played, "" where there is none: external clouds are looked for beside it,
  /// and rings and times of returns (SweepFolder.h).
  std::string rawlog;
  /// While observations come in, pictures, likelihoods and matchings see the map as it was at most
  /// this many scans ago; renewing it costs time that grows with the map.
  int refreshScans = 10;

  const char* section() const override { return "plugin"; }
  void visit(OptionVisitor& visitor) override;
};

/// The options of CDynamicFilteredPointsMap as they are in force, one member per section.
struct FilteredMapConfiguration {
  PlugInOptions plugin;
  SensorOptions sensor;
  PipelineOptions pipeline;

  /// One entry per section, in the order in which they are documented.
  std::vector<Options*> sections();
};

/// What is set for a CDynamicFilteredPointsMap; everything else has its default, or comes from the
/// preset of the sensor. Kept as text, since the preset is known with the first scan only.
struct FilteredMapOptions : mrpt::config::CLoadableOptions {
  /// Text of a configuration of `toss map` (config/toss.ini, config.ini of a run), or "".
  std::string configuration;
  /// "section.key=value" each, applied in this order after `configuration`.
  std::vector<std::string> settings;

  /// Reads a section whose keys are "config", the path of a configuration, and "section.key" as for
  /// `toss map --set`. Throws UserError for unknown keys and values out of range.
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& sectionName) override;
  void dumpToTextStream(std::ostream& out) const override;

  /// Defaults, then the preset of the sensor `preset` ("" = none), then `configuration`, then
  /// `settings`. Throws UserError where these can't be understood.
  FilteredMapConfiguration resolve(const std::string& preset) const;
};

}  // namespace toss
