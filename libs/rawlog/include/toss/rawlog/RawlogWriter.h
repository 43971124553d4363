// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace mrpt::serialization {
class CSerializable;
}

namespace toss {

/// Writes a rawlog in observation format with stock MRPT classes only. The file, and the folders
/// <stem>_labels and <stem>_sweeps beside it, appear under their names only when all is written:
/// call commit().
/// Files of the same name are replaced.
class RawlogWriter {
 public:
  /// `gz`: whether to compress. Off by default: it saves a quarter to a half of the size, and
  /// writing and reading take ten times as long or more. Throws UserError if the file can't be
  /// made.
  explicit RawlogWriter(const std::filesystem::path& file, bool gz = false);
  ~RawlogWriter();

  /// Writes CObservationRobotPose (map <- robot) and CObservationPointCloud (CPointsMapXYZI, sensor
  /// frame, all points in their order and with their bits; intensity 0 where there is none), both
  /// with the scan's time stamp rounded to MRPT's 100 ns. Reading gives the same pose bit for bit
  /// where robotFromSensor is the identity. Rings and times of the returns, `beams` and
  /// `motionCompensated`, where the scan has them, go to <stem>_sweeps (SweepFolder.h); `index` and
  /// `sensorModel` are not kept. Throws UserError if writing fails, or if the first scan comes
  /// without labels (rings, times, beams) while a folder <stem>_labels (<stem>_sweeps) of another
  /// log is there.
  void write(const PosedScan& scan);
  /// The same, and the scan's labels to <stem>_labels/%06d.label, numbered by the order of writing.
  /// `labels`: shape [points].
  void write(const PosedScan& scan, const std::vector<std::uint32_t>& labels);
  /// The same without labels and pose, for logs whose poses are not known yet.
  void writeWithoutPose(const PosedScan& scan);
  /// Writes any object, e.g. an observation of another class; it does not count as a scan.
  void write(const mrpt::serialization::CSerializable& object);

  /// Scans written so far.
  std::uint64_t scanCount() const;
  /// Closes and gives all files their names. Nothing may be written after it. Throws UserError.
  void commit();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
