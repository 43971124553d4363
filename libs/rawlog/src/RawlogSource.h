// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>
#include <toss/rawlog/ScanSource.h>
#include <toss/rawlog/SweepFolder.h>

#include <deque>
#include <map>
#include <optional>

#include "PoseBuffer.h"
#include "RawlogPoses.h"
#include "RawlogReader.h"
#include "ScanBookkeeping.h"

namespace toss {

/// The scans of a rawlog, each with the pose that the log holds for its time. Poses may come after
/// the scan: scans wait for them, at most options.lookAhead at a time.
class RawlogSource : public ScanSource {
 public:
  RawlogSource(const std::filesystem::path& file, const InputOptions& options);

  bool next(PosedScan& scan) override;
  double progress() const override { return reader_.progress(); }
  std::uint64_t scanCount() const override { return 0; }
  const InputReport& report() const override;

 private:
  /// What is known of a sensor that is read.
  struct Sensor {
    explicit Sensor(std::string itsLabel) : label(std::move(itsLabel)) {}
    std::string label;
    /// Scans met.
    std::uint64_t scans = 0;
    std::optional<PoseBuffer::Ticks> lastTime;
    /// Pose on the robot, by the first scan met.
    std::optional<Eigen::Isometry3d> robotFromSensor;
    SensorMemory model;
  };
  /// A scan that waits for its pose.
  struct Waiting {
    mrpt::obs::CObservation::Ptr observation;
    Sensor* sensor = nullptr;
    std::uint64_t index = 0;
    PoseBuffer::Ticks time = 0;
    std::string place;
  };
  enum class Decision { Wait, Deliver, Skip };

  bool readMore();
  mrpt::serialization::CSerializable::Ptr readObject();
  void take(const mrpt::obs::CObservation::Ptr& observation);
  Sensor* sensorOf(const std::string& label);
  void takeScan(const mrpt::obs::CObservation::Ptr& observation);
  Decision decide(const Waiting& front, std::optional<Eigen::Isometry3d>& pose) const;
  void load(const Waiting& from, const Eigen::Isometry3d& pose, PosedScan& scan);
  std::optional<Eigen::Isometry3d> poseFromSensor(const Sensor& sensor,
                                                  const PosedScan& scan) const;
  bool sweepGoesOn(const Waiting& from, const PosedScan& scan) const;
  void finish(const Waiting& from, PosedScan& scan);
  void failAtEnd() const;
  [[noreturn]] void failWithoutScans() const;

  InputOptions options_;
  /// Whether returns without times get those of input.sweep_...
  bool sweepIsKnown_;
  RawlogReader reader_;
  SweepFolder sweeps_;
  RawlogPoses poses_;
  std::deque<Waiting> waiting_;
  bool ended_ = false;
  /// Whether the scan that waits first has been loaded.
  bool loaded_ = false;
  /// What is wrong with the file where reading it ended, "" if nothing.
  std::string damage_;
  std::uint64_t nextIndex_ = 0;
  /// Those that are read, once known; they stay where they are in memory.
  std::deque<Sensor> sensors_;
  std::optional<PoseBuffer::Ticks> lastTime_, firstScanTime_;
  /// Observations by class or label that were left out.
  std::map<std::string, std::uint64_t> otherSensors_, otherRangeScans_;
  std::uint64_t withoutTime_ = 0, withoutSweep_ = 0;
  std::string firstSkippedForTime_;
  mutable InputReport report_;
};

}  // namespace toss
