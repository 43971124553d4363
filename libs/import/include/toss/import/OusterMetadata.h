// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace toss {

/// How the packets of an Ouster sensor are laid out (udp_profile_lidar).
enum class OusterProfile {
  Legacy,                   ///< LEGACY: firmware 1 and 2.0, and later by choice
  Rng19Rfl8Sig16Nir16,      ///< RNG19_RFL8_SIG16_NIR16: one return
  Rng19Rfl8Sig16Nir16Dual,  ///< RNG19_RFL8_SIG16_NIR16_DUAL: two returns
  Rng15Rfl8Nir8             ///< RNG15_RFL8_NIR8: one return, low data rate
};

/// The profile's name in the sensor's metadata.
const char* nameOf(OusterProfile profile);

/// What the metadata of an Ouster sensor tell of its packets and beams.
struct OusterMetadata {
  /// Product line, e.g. "OS-1-64"; "" where the file has none.
  std::string productLine;
  /// Serial number and number of the sensor's start; 0 where the file has none.
  std::uint64_t serialNumber = 0;
  std::uint32_t initializationId = 0;
  /// Port that the packets are sent to; 0 where the file does not tell.
  std::uint16_t lidarPort = 0;

  OusterProfile profile = OusterProfile::Legacy;
  /// Beams; columns (firings) in a packet and in a revolution.
  int pixelsPerColumn = 64, columnsPerPacket = 16, columnsPerFrame = 1024;
  /// First and last column that the sensor sends; first > last where the window contains column 0.
  int firstColumn = 0, lastColumn = 1023;
  /// Value of the reflectivity field that stands for 1: 255 where the sensor calibrates it.
  double fullReflectivity = 255.0;

  /// Elevation and azimuth offset of each beam [rad], shape [pixelsPerColumn], as in the packets.
  /// Azimuth offsets count clockwise seen from above, as the sensor turns.
  std::vector<double> beamAltitudes, beamAzimuths;
  /// Whether the beam exists, shape [pixelsPerColumn]: early sensors with 16 beams send 64 pixels.
  std::vector<bool> beamActive;
  /// Where the beams start, in the frame that turns with the encoder: forward and up from the
  /// LiDAR's origin [m].
  double beamOriginForward = 0.0, beamOriginUp = 0.0;
  /// LiDAR frame (the encoder's) to sensor frame (the housing's: x forward, z up, origin at its
  /// base) [m].
  Eigen::Isometry3d sensorFromLidar = Eigen::Isometry3d::Identity();

  /// What the file lacks and was taken from the data sheet instead: plain sentences.
  std::vector<std::string> notes;

  /// Columns within the window.
  int columnsInWindow() const;
  /// Whether the sensor sends the column, 0 to columnsPerFrame - 1.
  bool inWindow(int column) const;
};

/// Reads the metadata that the sensor hands out, as Ouster's programs save them beside a capture:
/// all on one level (firmware 1 to 2) or in sections (from 2.3 on), or only beams and mode. Throws
/// UserError naming the file and the entry where something is missing that no data sheet tells, or
/// contradicts the rest.
OusterMetadata readOusterMetadata(const std::filesystem::path& file);

}  // namespace toss
