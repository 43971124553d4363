// SPDX-License-Identifier: BSD-3-Clause
#include "RunConfiguration.h"

#include <toss/geometry/OptionSections.h>
#include <toss/rawlog/SensorPresets.h>
#include <toss/voting/KeepChoice.h>

namespace toss {

std::vector<Options*> RunConfiguration::sections() {
  std::vector<Options*> all = {&input, &sensor, &odometry};
  for (Options* section : pipeline.sections()) all.push_back(section);
  all.push_back(&render);
  return all;
}

RunConfiguration configure(const ConfigurationRequest& request, const std::string& model) {
  RunConfiguration configuration;
  leanTowards(keepFromName(request.keep), configuration.pipeline.decision);
  const std::vector<Options*> sections = configuration.sections();
  if (const auto preset = sensorPresets().find(model); preset != sensorPresets().end())
    loadSectionsFromText(preset->second, "config/sensors/" + model + ".ini", sections);
  if (!request.file.empty()) loadSections(request.file, sections);
  for (const std::string& setting : request.settings) setOption(setting, sections);
  if (!request.poses.empty()) configuration.input.poseFile = request.poses;
  return configuration;
}

}  // namespace toss
