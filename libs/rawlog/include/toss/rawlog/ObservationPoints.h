// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>
#include <toss/geometry/PosedScan.h>

#include <filesystem>
#include <string>

namespace toss {

/// Whether the observation's points can be read: CObservationPointCloud, CObservationVelodyneScan,
/// CObservationRotatingScan.
bool holdsPoints(const mrpt::obs::CObservation& observation);

/// Reads the points of an observation into `scan.points`, in the observation's order; for Velodyne
/// packets that of generatePointCloud() with its default parameters, and behind them, in the same
/// order, the returns that MRPT 2.5.8 leaves out (the second 16 of each block); of a
/// range image every pixel, row after row, those without a return at the origin. `scan.sensorModel`
/// and `scan.beams` are set where the observation tells them, else "" and null;
/// `scan.motionCompensated` becomes false. `rawlog`: where external files are looked for
/// (<stem>_Images beside it). `place`: names the observation in errors. Throws UserError if an
/// external file is missing or damaged, or the beams of a range image are not known,
/// std::logic_error if !holdsPoints(observation).
void readPoints(mrpt::obs::CObservation& observation, const std::filesystem::path& rawlog,
                const std::string& place, PosedScan& scan);

/// Sets time, poses and label of a scan from its observation; `mapFromRobot`: pose of the robot at
/// that time. Throws UserError naming `place` if the observation's sensor pose is no rigid motion.
void placeScan(const mrpt::obs::CObservation& observation, const Eigen::Isometry3d& mapFromRobot,
               const std::string& place, PosedScan& scan);

/// The same as readPoints for one kind of observation each.
void readVelodynePoints(mrpt::obs::CObservation& observation, PosedScan& scan);
void readRotatingPoints(mrpt::obs::CObservation& observation, const std::string& place,
                        PosedScan& scan);
void readCloudPoints(mrpt::obs::CObservation& observation, const std::filesystem::path& rawlog,
                     const std::string& place, PosedScan& scan);

}  // namespace toss
