// SPDX-License-Identifier: BSD-3-Clause
// How MRPT gets to know the class, and makes maps of it from a section of a configuration.
#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/core/initializer.h>
#include <toss/geometry/Options.h>
#include <toss/mrpt/CDynamicFilteredPointsMap.h>

#include <algorithm>

#include "PlugInError.h"

MAP_DEFINITION_REGISTER("toss::CDynamicFilteredPointsMap,dynamicFilteredPointsMap",
                        toss::CDynamicFilteredPointsMap)

MRPT_INITIALIZER(registerTossClasses) {
  mrpt::rtti::registerClass(CLASS_ID(toss::CDynamicFilteredPointsMap));
}

namespace toss {
namespace {

using mrpt::config::CConfigFileBase;

void checkKeys(const CConfigFileBase& source, const std::string& section,
               const std::vector<std::string>& known) {
  std::vector<std::string> keys;
  source.getAllKeys(section, keys);
  for (const std::string& key : keys)
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw UserError("[" + section + "] " + key, "there is no such key",
                      "did you mean '" + nearestName(key, known) + "'?");
}

/// MRPT itself passes over sections and keys that it does not know.
void checkSections(const CConfigFileBase& source, const std::string& prefix) {
  const std::vector<std::string> known = {prefix + "_creationOpts", prefix + "_insertOpts",
                                          prefix + "_likelihoodOpts"};
  std::vector<std::string> sections;
  source.getAllSections(sections);
  for (const std::string& section : sections)
    if (section.rfind(prefix + "_", 0) == 0 &&
        std::find(known.begin(), known.end(), section) == known.end())
      throw UserError("[" + section + "]", "the map has no such section",
                      "did you mean '" + nearestName(section, known) + "'?");
  checkKeys(source, known[0],
            {"enableSaveAs3DObject", "enableObservationLikelihood", "enableObservationInsertion"});
  checkKeys(source, known[2], {"sigma_dist", "max_corr_distance", "decimation"});
}

}  // namespace

CDynamicFilteredPointsMap::TMapDefinition::TMapDefinition() = default;

void CDynamicFilteredPointsMap::TMapDefinition::loadFromConfigFile_map_specific(
    const CConfigFileBase& source, const std::string& prefix) {
  passingUserErrors([&] { checkSections(source, prefix); });
  insertionOpts.loadFromConfigFile(source, prefix + "_insertOpts");
  likelihoodOpts.loadFromConfigFile(source, prefix + "_likelihoodOpts");
}

void CDynamicFilteredPointsMap::TMapDefinition::dumpToTextStream_map_specific(
    std::ostream& out) const {
  insertionOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
}

CreatedMetricMap CDynamicFilteredPointsMap::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition) {
  const auto& own = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CDynamicFilteredPointsMap>();
  map->insertionOptions = own.insertionOpts;
  map->likelihoodOptions = own.likelihoodOpts;
  return CreatedMetricMap(map.release());
}

}  // namespace toss
