// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/COutputLogger.h>
#include <toss/mrpt/FilteredMapOptions.h>
#include <toss/pipeline/MultiLidarPipeline.h>
#include <toss/rawlog/SweepFolder.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace toss {

/// Reads the points of an observation, wherever they are kept. `rawlog`: see PlugInOptions. Throws
/// UserError where they can't be read.
void readObservation(const mrpt::obs::CObservation& observation, const std::string& rawlog,
                     PosedScan& scan);

/// One run of the method over observations, from the first one to finish().
class MappingSession {
 public:
  /// Throws UserError for options out of range.
  explicit MappingSession(const FilteredMapOptions& options);

  /// Takes the next scan; `mapFromRobot`: pose of the robot at its time. False where it is refused:
  /// no points, no time stamp, not later than the one before of its sensor, a sensor at the place
  /// of another one. Each reason is logged once. Throws UserError where it can't be read.
  bool insert(const mrpt::obs::CObservation& observation, const Eigen::Isometry3d& mapFromRobot);
  /// Scans taken.
  std::uint64_t scanCount() const { return scan_.index; }
  /// See PlugInOptions.
  int refreshScans() const { return configuration_.plugin.refreshScans; }
  /// The map by present knowledge, all scans included.
  std::vector<MapPoint> presentMap() const;
  /// The map when everything is decided. To be called once, last.
  std::vector<MapPoint> finish();

 private:
  struct Lidar;
  bool refuses(const mrpt::obs::CObservation& observation);
  /// nullptr where it is none of those that are taken.
  Lidar* lidarOf(const mrpt::obs::CObservation& observation);
  bool refuse(const std::string& reason);
  void addLidar();

  FilteredMapOptions options_;
  FilteredMapConfiguration configuration_;
  std::optional<SweepFolder> sweeps_;
  MultiLidarPipeline pipeline_;
  /// The next scan; its index counts those taken.
  PosedScan scan_;
  /// A sensor whose scans are taken.
  struct Lidar {
    std::string label;
    mrpt::poses::CPose3D place;
    std::optional<mrpt::Clock::time_point> lastTime{};
  };
  std::vector<Lidar> lidars_;
  std::set<std::string> reasonsTold_;
  mrpt::system::COutputLogger log_{"toss::CDynamicFilteredPointsMap"};
};

}  // namespace toss
