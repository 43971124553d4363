// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/OusterMetadata.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace toss {

/// One revolution of an Ouster sensor, as its packets tell it: rows are beams in the packets'
/// order, columns the firings of the revolution (not shifted by the beams' azimuth offsets).
struct OusterFrame {
  /// Number of the revolution, modulo 65536.
  std::uint16_t id = 0;
  int rows = 0, columns = 0;
  /// Of each column, shape [columns]: time by the sensor's clock [ns], number, status as sent; all
  /// 0 where the column did not come.
  std::vector<std::uint64_t> timestamp;
  std::vector<std::uint16_t> measurementId;
  std::vector<std::uint32_t> status;
  /// Whether the column came and was measured, shape [columns].
  std::vector<std::uint8_t> valid;
  /// First and, in profiles that have it, second return of each pixel, shape [rows * columns], row
  /// after row: range [mm] (0 = none) and reflectivity as sent.
  struct Returns {
    std::vector<std::uint32_t> range;
    std::vector<std::uint16_t> reflectivity;
  };
  std::array<Returns, 2> returns;
  /// Capture time of the packet that brought the first column [ns, UNIX time], and that column's
  /// own time [ns, sensor's clock].
  std::int64_t captureTime = 0;
  std::uint64_t captureTimestamp = 0;

  /// Columns that are valid.
  int validColumns() const;
};

/// What reading frames has found so far.
struct OusterFrameReport {
  /// Frames delivered, packets used, columns within the sensor's window that did not come or were
  /// not measured, and frames between two others of which nothing came.
  std::uint64_t frames = 0, packets = 0, lostColumns = 0, lostFrames = 0;
  /// Packets left out: of other sensors; of another size than the metadata tell, although from the
  /// same sender; with a wrong check sum; of a frame that was over already.
  std::uint64_t otherSensors = 0, wrongSize = 0, wrongCheckSum = 0, late = 0;
  /// Columns left out because their number is none.
  std::uint64_t wrongColumns = 0;
  /// Whether the sensor was started anew since its metadata were saved.
  bool restarted = false;
};

/// Puts the packets of one sensor in a capture together to frames, one at a time in constant
/// memory. Looks through the first packets to find that sensor: by the metadata's serial number,
/// else by their port, else the first sender whose packets have the right size.
class OusterFrameReader {
 public:
  /// Throws UserError where the capture can't be read, or holds no packets that the metadata fit.
  OusterFrameReader(const std::filesystem::path& capture, const OusterMetadata& metadata);
  ~OusterFrameReader();

  /// Reads the next frame that has a valid column, reusing its buffers; false at the end.
  bool next(OusterFrame& frame);
  /// Share of the capture that has been read, 0 to 1.
  double progress() const;
  const OusterFrameReport& report() const;
  /// Plain sentences for the user about all of it, the capture's own damage included.
  std::vector<std::string> warnings() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
