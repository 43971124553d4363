// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/InputOptions.h>

namespace toss {

void InputOptions::visit(OptionVisitor& visitor) {
  const char* own = "TOSS";
  visitor.string({"sensor_label", "",
                  "Label of the sensor whose scans are read; empty takes the "
                  "first one met, and toss map all LiDARs of the log.",
                  own},
                 sensorLabel);
  visitor.string({"pose_label", "",
                  "Label of the pose observations that are used; empty takes the "
                  "first one met.",
                  own},
                 poseLabel);
  visitor.choice({"pose_source", "",
                  "Where poses come from: CObservationRobotPose; odometry "
                  "(CObservationOdometry or action increments), which drifts; or gps "
                  "(CObservationGPS), good to metres, with the heading of the path and level.",
                  own},
                 poseSource, {"observations", "odometry", "gps"});
  visitor.string({"pose_file", "",
                  "File with poses in TUM or KITTI format, which replace those of the input; empty "
                  "takes the input's own.",
                  own},
                 poseFile);
  visitor.choice({"pose_of", "",
                  "What the poses of pose_file are of: sensor = the LiDAR, robot = the robot that "
                  "carries it, camera = KITTI's camera; automatic takes camera for a file in KITTI "
                  "format and a folder with calib.txt, else sensor.",
                  own},
                 poseOf, {"automatic", "sensor", "robot", "camera"});
  visitor.real({"max_pose_gap", "s",
                "A scan between two poses is used only if both are at most "
                "this far away in time; larger values interpolate over longer gaps.",
                own},
               maxPoseGap, 0.0, 60.0);
  visitor.real({"time_offset", "s",
                "Added to the time stamp of a scan before its pose is looked "
                "up, for sensors whose clock differs from that of the poses.",
                own},
               timeOffset, -60.0, 60.0);
  visitor.integer({"look_ahead", "scans",
                   "Scans that may wait for a pose which comes later in the "
                   "log; larger values take more memory.",
                   own},
                  lookAhead, 1, 100000);
  visitor.real({"scan_period", "s", "Time between scans of a KITTI folder without times.txt.",
                "KITTI: 10 Hz"},
               scanPeriod, 1e-4, 3600.0);
  visitor.choice({"deskew", "",
                  "Compensation of the sensor's motion during a sweep: auto where returns have "
                  "times, poses lie around the sweep and the log does not say that it is done; "
                  "sweep does so for returns without times too, by their azimuth: the scans must "
                  "not be compensated yet, and the sweep_ options below must be true.",
                  own},
                 deskew, {"auto", "off", "sweep"});
  visitor.real({"sweep_rate", "Hz", "deskew=sweep: turns of the sensor per second.", own},
               sweepRate, 0.1, 200.0);
  visitor.choice({"sweep_sense", "", "deskew=sweep: sense of rotation, seen from above.",
                  "Velodyne, Ouster: clockwise"},
                 sweepSense, {"clockwise", "counterclockwise"});
  visitor.real({"sweep_start", "deg",
                "deskew=sweep: azimuth at which a sweep begins, counterclockwise from the "
                "sensor's x axis.",
                own},
               sweepStart, -360.0, 360.0);
  visitor.real({"sweep_stamp", "",
                "deskew=sweep: where in the sweep a scan's time stamp lies, 0 at its begin, 1 at "
                "its end.",
                own},
               sweepStamp, 0.0, 1.0);
}

}  // namespace toss
