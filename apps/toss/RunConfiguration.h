// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/odometry/OdometryOptions.h>
#include <toss/pipeline/PipelineOptions.h>
#include <toss/rawlog/InputOptions.h>
#include <toss/rawlog/SensorChoice.h>
#include <toss/render/RenderOptions.h>

#include <string>
#include <vector>

namespace toss {

/// Everything that a run can be told.
struct RunConfiguration {
  InputOptions input;
  SensorOptions sensor;
  OdometryOptions odometry;
  PipelineOptions pipeline;
  RenderOptions render;

  /// One entry per section, in the order in which they are documented.
  std::vector<Options*> sections();
};

/// What the user asks for on the command line.
struct ConfigurationRequest {
  /// What to do in doubt: "static", "balanced" or "remove".
  std::string keep = "balanced";
  /// An .ini, or "".
  std::string file;
  /// "section.key=value" each.
  std::vector<std::string> settings;
  /// A pose file, or "": the same as input.pose_file, and above it.
  std::string poses;
};

/// Defaults, leaning towards what is to be kept, then the preset of the sensor `model` ("" = none),
/// then the request's file, then its settings, then its poses. Throws UserError where the
/// request can't be understood.
RunConfiguration configure(const ConfigurationRequest& request, const std::string& model);

}  // namespace toss
