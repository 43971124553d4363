// SPDX-License-Identifier: BSD-3-Clause
// A program of MRPT's that knows nothing of TOSS: it loads the plug-in and maps a rawlog with it.
//
//   dynamic_filtered_map libtoss-mrpt.so map.ini LOG.rawlog PREFIX
//
// leaves PREFIX_<class>_00.ply and .metricmap. The log holds CObservationRobotPose before each
// scan.
#include <mrpt/config/CConfigFile.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/system/os.h>

#include <iostream>

namespace {

/// Poses and scans of the log, one after the other, in constant memory.
void insertLog(const std::string& file, mrpt::maps::CMultiMetricMap& maps) {
  mrpt::io::CFileGZInputStream stream(file);
  auto archive = mrpt::serialization::archiveFrom(stream);
  mrpt::poses::CPose3D robotPose;
  try {
    for (;;) {
      const auto observation = archive.ReadObject<mrpt::obs::CObservation>();
      if (IS_CLASS(*observation, mrpt::obs::CObservationRobotPose))
        robotPose = dynamic_cast<mrpt::obs::CObservationRobotPose&>(*observation).pose.mean;
      else
        maps.insertObservation(*observation, robotPose);
    }
  } catch (const mrpt::serialization::CExceptionEOF&) {
    return;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: dynamic_filtered_map PLUGIN.so MAP.ini LOG.rawlog PREFIX\n";
    return 1;
  }
  try {
    std::string error;
    if (!mrpt::system::loadPluginModule(argv[1], error)) throw std::runtime_error(error);
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    definitions.loadFromConfigFile(mrpt::config::CConfigFile(argv[2]), "map");
    mrpt::maps::CMultiMetricMap maps;
    maps.setListOfMaps(definitions);
    insertLog(argv[3], maps);
    maps.saveMetricMapRepresentationToFile(argv[4]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
