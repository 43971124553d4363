// SPDX-License-Identifier: BSD-3-Clause

#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/ObservationPoints.h>

#include <stdexcept>

namespace toss {

bool holdsPoints(const mrpt::obs::CObservation& observation) {
  return IS_CLASS(observation, mrpt::obs::CObservationPointCloud) ||
         IS_CLASS(observation, mrpt::obs::CObservationVelodyneScan) ||
         IS_CLASS(observation, mrpt::obs::CObservationRotatingScan);
}

void readPoints(mrpt::obs::CObservation& observation, const std::filesystem::path& rawlog,
                const std::string& place, PosedScan& scan) {
  if (!holdsPoints(observation))
    throw std::logic_error("readPoints: an observation that holds no points");
  scan.sensorModel.clear();
  scan.beams = nullptr;
  scan.motionCompensated = false;
  if (IS_CLASS(observation, mrpt::obs::CObservationPointCloud)) {
    readCloudPoints(observation, rawlog, place, scan);
    return;
  }
  if (IS_CLASS(observation, mrpt::obs::CObservationRotatingScan)) {
    readRotatingPoints(observation, place, scan);
    return;
  }
  try {
    readVelodynePoints(observation, scan);
  } catch (const std::exception&) {
    throw UserError(place, "its Velodyne packets can't be decoded",
                    "record the log again with the calibration of the sensor in it");
  }
}

void placeScan(const mrpt::obs::CObservation& observation, const Eigen::Isometry3d& mapFromRobot,
               const std::string& place, PosedScan& scan) {
  mrpt::poses::CPose3D sensorPose;
  observation.getSensorPose(sensorPose);
  scan.time = fromMrptTime(observation.timestamp);
  scan.robotFromSensor = fromMrpt(sensorPose);
  if (!isRigid(scan.robotFromSensor))
    throw UserError(place, "its sensor pose is no rigid motion", "repair the log");
  // Without a sensor pose nothing is multiplied, so that the bits stay.
  const bool atOrigin = scan.robotFromSensor.matrix() == Eigen::Matrix4d::Identity();
  scan.mapFromSensor = atOrigin ? mapFromRobot : mapFromRobot * scan.robotFromSensor;
  scan.sensorLabel = observation.sensorLabel;
}

}  // namespace toss
