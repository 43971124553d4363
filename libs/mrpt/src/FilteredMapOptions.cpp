// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/config/CConfigFileBase.h>
#include <toss/geometry/OptionSections.h>
#include <toss/mrpt/FilteredMapOptions.h>
#include <toss/rawlog/SensorPresets.h>

#include <fstream>
#include <sstream>

#include "PlugInError.h"

namespace toss {
namespace {

/// The configuration without the sections that are about files: they have no meaning here. Lines
/// keep their numbers.
std::string withoutFileSections(const std::string& text) {
  std::istringstream in(text);
  std::ostringstream out;
  bool skipping = false;
  for (std::string line; std::getline(in, line); out << (skipping ? "" : line) << "\n") {
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] != '[') continue;
    const std::string section = line.substr(first, line.find(']', first) + 1 - first);
    skipping = section == "[input]" || section == "[odometry]" || section == "[render]";
  }
  return out.str();
}

std::string readText(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf()))
    throw UserError(file, "the configuration can not be read",
                    "give the path of an .ini file, such as config/toss.ini");
  return withoutFileSections(text.str());
}

}  // namespace

void PlugInOptions::visit(OptionVisitor& visitor) {
  const char* own = "TOSS";
  visitor.string({"sensor_label", "",
                  "Label of the sensor whose scans are taken; empty takes all LiDARs.", own},
                 sensorLabel);
  visitor.string({"rawlog", "",
                  "The rawlog that is played: external clouds, rings and times of returns are "
                  "looked for beside it.",
                  own},
                 rawlog);
  visitor.integer({"refresh_scans", "scans",
                   "Age that the map may have for pictures, likelihoods and matchings while "
                   "observations come in; larger values cost less time.",
                   own},
                  refreshScans, 1, 100000);
}

std::vector<Options*> FilteredMapConfiguration::sections() {
  std::vector<Options*> all = {&plugin, &sensor};
  for (Options* section : pipeline.sections()) all.push_back(section);
  return all;
}

void FilteredMapOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                            const std::string& sectionName) {
  passingUserErrors([&] {
    FilteredMapConfiguration trial;
    std::vector<std::string> keys;
    source.getAllKeys(sectionName, keys);
    for (const std::string& key : keys) {
      const std::string value = source.read_string(sectionName, key, "");
      if (key == "config") {
        configuration = readText(value);
        loadSectionsFromText(configuration, value, trial.sections());
        continue;
      }
      setOption(key + "=" + value, trial.sections(), "[" + sectionName + "] " + key);
      settings.push_back(key + "=" + value);
    }
  });
}

void FilteredMapOptions::dumpToTextStream(std::ostream& out) const {
  out << "[toss::FilteredMapOptions]\n";
  for (const std::string& setting : settings) out << setting << "\n";
  out << configuration;
}

FilteredMapConfiguration FilteredMapOptions::resolve(const std::string& preset) const {
  FilteredMapConfiguration result;
  const std::vector<Options*> sections = result.sections();
  if (const auto found = sensorPresets().find(preset); found != sensorPresets().end())
    loadSectionsFromText(found->second, "config/sensors/" + preset + ".ini", sections);
  loadSectionsFromText(configuration, "the configuration of the map", sections);
  for (const std::string& setting : settings) setOption(setting, sections, setting);
  return result;
}

}  // namespace toss
