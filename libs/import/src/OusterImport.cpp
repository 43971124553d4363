// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/import/OusterImport.h>
#include <toss/import/OusterPoints.h>
#include <toss/rawlog/PoseFile.h>
#include <toss/rawlog/RawlogWriter.h>

#include <cmath>
#include <optional>

#include "OusterClock.h"

namespace toss {
namespace {

/// Poses of the frames, by the clock that the pose file goes by.
class FramePoses {
 public:
  explicit FramePoses(const OusterImportOptions& options) {
    if (!options.poses.empty()) file_.emplace(options.poses, options.maxPoseGap);
  }

  bool given() const { return file_.has_value(); }

  std::optional<Eigen::Isometry3d> at(std::uint64_t frame, std::uint64_t sensorTime,
                                      double unixTime) const {
    const bool tum = file_->format() == PoseFileFormat::Tum;
    const bool bySensor = tum && OusterClock::countsFromStart(file_->times().front());
    return file_->at(frame, bySensor ? 1e-9 * static_cast<double>(sensorTime) : unixTime);
  }

 private:
  std::optional<PoseFile> file_;
};

class Import {
 public:
  Import(const std::filesystem::path& capture, const OusterMetadata& metadata,
         const std::filesystem::path& rawlog, const OusterImportOptions& options)
      : frames_(capture, metadata),
        points_(metadata),
        poses_(options),
        writer_(rawlog, options.gz),
        label_(options.sensorLabel.empty() ? sensorModelOf(metadata).name : options.sensorLabel) {}

  void run(const std::function<void(double)>& progress) {
    OusterFrame frame;
    PosedScan scan;
    scan.sensorLabel = label_;
    std::optional<double> lastTime;
    for (std::uint64_t number = 0; frames_.next(frame); ++number) {
      const std::uint64_t sensorTime = OusterPoints::timeOf(frame);
      scan.time = clock_.unixTime(frame, sensorTime);
      if (lastTime && scan.time <= *lastTime) {
        ++result_.notLater;
        continue;
      }
      lastTime = scan.time;
      points_.toScan(frame, scan);
      write(scan, number, sensorTime);
      if (progress) progress(frames_.progress());
    }
  }

  OusterImportResult finish(const std::filesystem::path& capture, const OusterMetadata& metadata,
                            const OusterImportOptions& options) {
    result_.scans = writer_.scanCount();
    result_.frames = frames_.report();
    for (const std::string& note : metadata.notes) result_.warnings.push_back(note);
    for (const std::string& warning : frames_.warnings()) result_.warnings.push_back(warning);
    for (const std::string& note : clock_.notes()) result_.warnings.push_back(note);
    warn(result_.withoutPose,
         "frames were left out, " + options.poses.string() + " has no pose for them");
    warn(result_.notLater, "frames were left out, they are not later than the one before");
    if (result_.scans == 0)
      throw UserError(capture.string(),
                      result_.withoutPose > 0
                          ? "none of its " + std::to_string(result_.withoutPose) +
                                " frames has a pose in " + options.poses.string()
                          : "holds no frame of the sensor",
                      result_.withoutPose > 0 ? "check that both are of the same drive and clock"
                                              : "record it again");
    writer_.commit();
    return result_;
  }

 private:
  void write(PosedScan& scan, std::uint64_t frame, std::uint64_t sensorTime) {
    if (!poses_.given()) {
      writer_.writeWithoutPose(scan);
    } else if (const auto mapFromHousing = poses_.at(frame, sensorTime, scan.time)) {
      scan.mapFromSensor = *mapFromHousing * scan.robotFromSensor;
      writer_.write(scan);
      ++result_.posed;
    } else {
      ++result_.withoutPose;
      return;
    }
    result_.points += scan.points.size();
  }

  void warn(std::uint64_t count, const std::string& text) {
    if (count > 0) result_.warnings.push_back(std::to_string(count) + " " + text);
  }

  OusterFrameReader frames_;
  OusterPoints points_;
  FramePoses poses_;
  RawlogWriter writer_;
  OusterClock clock_;
  std::string label_;
  OusterImportResult result_;
};

}  // namespace

OusterImportResult importOuster(const std::filesystem::path& capture,
                                const std::filesystem::path& metadata,
                                const std::filesystem::path& rawlog,
                                const OusterImportOptions& options) {
  const OusterMetadata sensor = readOusterMetadata(metadata);
  Import import(capture, sensor, rawlog, options);
  import.run(options.progress);
  return import.finish(capture, sensor, options);
}

}  // namespace toss
