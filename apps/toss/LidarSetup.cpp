// SPDX-License-Identifier: BSD-3-Clause
#include "LidarSetup.h"

#include <toss/geometry/OptionSections.h>

#include <limits>
#include <set>
#include <sstream>

#include "SensorOfInput.h"

namespace toss {
namespace {

LidarSetup setUp(const std::filesystem::path& path, const ConfigurationRequest& request,
                 const std::string& label, const InputOptions& input, std::uint64_t from,
                 std::uint64_t to) {
  RunConfiguration first = configure(request, "");
  first.input = input;
  LidarSetup setup;
  setup.label = label;
  setup.sensor = sensorOfInput(path, first, from, to);
  setup.configuration = configure(request, setup.sensor.preset);
  return setup;
}

/// "section.key" of all options in which LiDARs differ.
std::set<std::string> differences(std::vector<LidarSetup>& lidars) {
  std::set<std::string> result;
  const auto sections = lidars.front().configuration.sections();
  for (LidarSetup& lidar : lidars) {
    const auto others = lidar.configuration.sections();
    for (std::size_t s = 0; s < sections.size(); ++s) {
      const auto values = sections[s]->values(), otherValues = others[s]->values();
      for (std::size_t k = 0; k < values.size(); ++k)
        if (values[k] != otherValues[k])
          result.insert(std::string(sections[s]->section()) + "." + values[k].first);
    }
  }
  return result;
}

}  // namespace

std::vector<LidarSetup> setUpLidars(const std::filesystem::path& path,
                                    const ConfigurationRequest& request,
                                    const LidarSelection& selection, const InputOptions& input,
                                    std::uint64_t from, std::uint64_t to) {
  if (selection.labels.size() < 2) return {setUp(path, request, "", input, from, to)};
  std::vector<LidarSetup> lidars;
  for (const std::string& label : selection.labels) {
    // Which model it is does not depend on the range, nor on whether its scans have poses.
    InputOptions alone = input;
    alone.sensorLabels = {label};
    alone.withoutPoses = true;
    lidars.push_back(
        setUp(path, request, label, alone, 0, std::numeric_limits<std::uint64_t>::max()));
  }
  return lidars;
}

std::string configurationText(std::vector<LidarSetup>& lidars) {
  const std::set<std::string> different = differences(lidars);
  std::istringstream in(sectionsToText(lidars.front().configuration.sections()));
  std::string text, line, section;
  while (std::getline(in, line)) {
    if (!line.empty() && line[0] == '[') section = line.substr(1, line.find(']') - 1);
    const bool isValue = !line.empty() && line[0] != '#' && line[0] != '[';
    if (isValue && different.count(section + "." + line.substr(0, line.find(' '))) > 0)
      line = "# each LiDAR has the value of its preset (config/sensors)";
    text += line + "\n";
  }
  return text;
}

}  // namespace toss
