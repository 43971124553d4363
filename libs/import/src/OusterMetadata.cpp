// SPDX-License-Identifier: BSD-3-Clause
#include <toss/import/OusterMetadata.h>
#include <toss/rawlog/MrptConversion.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "OusterMetadataEntries.h"

namespace toss {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;
constexpr double kMetersPerMillimeter = 1e-3;

constexpr std::array<std::pair<OusterProfile, const char*>, 4> kProfiles = {{
    {OusterProfile::Legacy, "LEGACY"},
    {OusterProfile::Rng19Rfl8Sig16Nir16, "RNG19_RFL8_SIG16_NIR16"},
    {OusterProfile::Rng19Rfl8Sig16Nir16Dual, "RNG19_RFL8_SIG16_NIR16_DUAL"},
    {OusterProfile::Rng15Rfl8Nir8, "RNG15_RFL8_NIR8"},
}};

OusterProfile profileByName(const OusterMetadataEntries& entries, const std::string& name) {
  for (const auto& [profile, known] : kProfiles)
    if (name == known) return profile;
  entries.fail(
      "udp_profile_lidar", "is '" + name + "', which is not read",
      std::string("record with udp_profile_lidar ") + nameOf(OusterProfile::Rng19Rfl8Sig16Nir16));
}

/// Columns of a revolution in a mode such as "1024x10".
int columnsOfMode(const OusterMetadataEntries& entries, const std::string& mode) {
  for (const int columns : {512, 1024, 2048, 4096})
    if (mode.rfind(std::to_string(columns) + "x", 0) == 0) return columns;
  entries.fail("lidar_mode", "is '" + mode + "', which is not known");
}

void readFormat(const OusterMetadataEntries& entries, OusterMetadata& metadata) {
  const auto profile = entries.text("udp_profile_lidar");
  if (profile) metadata.profile = profileByName(entries, *profile);
  const auto whole = [&](const char* name, std::uint64_t highest, int otherwise) {
    const auto value = entries.wholeNumber(name, highest);
    if (value && *value == 0) entries.fail(name, "is 0");
    return value ? static_cast<int>(*value) : otherwise;
  };
  const auto mode = entries.text("lidar_mode");
  const int columns = mode && !mode->empty() ? columnsOfMode(entries, *mode) : 0;
  metadata.columnsPerFrame = whole("columns_per_frame", 8192, columns);
  if (metadata.columnsPerFrame == 0) entries.fail("lidar_mode", "is missing");
  metadata.columnsPerPacket = whole("columns_per_packet", 128, 16);
  metadata.pixelsPerColumn = whole("pixels_per_column", 256, 64);
  const double last = metadata.columnsPerFrame - 1;
  const std::vector<double> window =
      entries.numbers("column_window", 2).value_or(std::vector<double>{0.0, last});
  for (const double column : window)
    if (column < 0.0 || column > last || column != std::floor(column))
      entries.fail("column_window", "lies outside of the revolution's columns");
  metadata.firstColumn = static_cast<int>(window[0]);
  metadata.lastColumn = static_cast<int>(window[1]);
}

/// Firmware 2.1 brought reflectivities from 0 to 255; before, and in unknown firmware, the legacy
/// profile has 16 bits, not calibrated.
bool calibratesReflectivity(const OusterMetadata& metadata, const std::string& revision) {
  if (metadata.profile != OusterProfile::Legacy) return true;
  int major = 0, minor = 0;
  const std::size_t begin = revision.find_first_of("0123456789");
  if (begin == std::string::npos) return false;
  if (std::sscanf(revision.c_str() + begin, "%3d.%3d", &major, &minor) != 2) return false;
  return major > 2 || (major == 2 && minor >= 1);
}

void readIdentity(const OusterMetadataEntries& entries, OusterMetadata& metadata) {
  metadata.productLine = entries.text("prod_line").value_or("");
  metadata.serialNumber = entries.wholeNumber("prod_sn", 0xFFFFFFFFFFu).value_or(0);
  metadata.initializationId =
      static_cast<std::uint32_t>(entries.wholeNumber("initialization_id", 0xFFFFFFFFu).value_or(0));
  metadata.lidarPort =
      static_cast<std::uint16_t>(entries.wholeNumber("udp_port_lidar", 65535).value_or(0));
  const std::string revision = entries.text("build_rev").value_or("");
  metadata.fullReflectivity = calibratesReflectivity(metadata, revision) ? 255.0 : 65535.0;
}

std::vector<double> readAngles(const OusterMetadataEntries& entries, const char* name,
                               const OusterMetadata& metadata, double largest) {
  auto angles = entries.numbers(name, static_cast<std::size_t>(metadata.pixelsPerColumn));
  if (!angles) entries.fail(name, "is missing");
  for (double& angle : *angles) {
    if (std::abs(angle) > largest) entries.fail(name, "holds an angle that no beam can have");
    angle *= kRadiansPerDegree;
  }
  return *angles;
}

void readBeams(const OusterMetadataEntries& entries, OusterMetadata& metadata) {
  metadata.beamAltitudes = readAngles(entries, "beam_altitude_angles", metadata, 90.0);
  metadata.beamAzimuths = readAngles(entries, "beam_azimuth_angles", metadata, 180.0);
  int active = 0;
  for (std::size_t i = 0; i < metadata.beamAltitudes.size(); ++i) {
    metadata.beamActive.push_back(metadata.beamAltitudes[i] != 0.0 ||
                                  metadata.beamAzimuths[i] != 0.0);
    active += metadata.beamActive.back();
  }
  if (active < 2) entries.fail("beam_altitude_angles", "holds no beams, only zeros");
}

/// Data sheets: distance of the beams' origins from the LiDAR's [mm].
double beamOriginOf(const std::string& productLine) {
  const auto is = [&](const char* line) { return productLine.rfind(line, 0) == 0; };
  return is("OS-0-") ? 27.67 : is("OS-1-") ? 15.806 : is("OS-2-") ? 13.762 : 12.163;
}

void readBeamOrigin(const OusterMetadataEntries& entries, OusterMetadata& metadata) {
  constexpr double kFarthest = 500.0;
  double forward = 0.0, up = 0.0;
  if (const auto transform = entries.numbers("beam_to_lidar_transform", 16)) {
    forward = (*transform)[3];
    up = (*transform)[11];
  } else if (const auto distance = entries.number("lidar_origin_to_beam_origin_mm")) {
    forward = *distance;
  } else {
    forward = beamOriginOf(metadata.productLine);
    metadata.notes.push_back(
        "the metadata do not tell where the beams start, the data sheet's distance was used");
  }
  if (std::abs(forward) > kFarthest || std::abs(up) > kFarthest)
    entries.fail("lidar_origin_to_beam_origin_mm", "lies outside of the sensor");
  metadata.beamOriginForward = forward * kMetersPerMillimeter;
  metadata.beamOriginUp = up * kMetersPerMillimeter;
}

void readTransform(const OusterMetadataEntries& entries, OusterMetadata& metadata) {
  constexpr const char* kName = "lidar_to_sensor_transform";
  // Data sheets: the encoder counts from the cable's side; the LiDAR is 36.18 mm above the base.
  std::vector<double> rows = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 36.18, 0, 0, 0, 1};
  if (const auto given = entries.numbers(kName, 16))
    rows = *given;
  else
    metadata.notes.push_back(
        "the metadata have no lidar_to_sensor_transform, the data sheet's was used");
  metadata.sensorFromLidar.matrix() =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.data());
  metadata.sensorFromLidar.translation() *= kMetersPerMillimeter;
  if (!isRigid(metadata.sensorFromLidar)) entries.fail(kName, "is no rigid motion");
}

}  // namespace

const char* nameOf(OusterProfile profile) {
  for (const auto& [known, name] : kProfiles)
    if (known == profile) return name;
  return "";
}

int OusterMetadata::columnsInWindow() const {
  const int columns = lastColumn - firstColumn + 1;
  return columns > 0 ? columns : columns + columnsPerFrame;
}

bool OusterMetadata::inWindow(int column) const {
  return firstColumn <= lastColumn ? column >= firstColumn && column <= lastColumn
                                   : column >= firstColumn || column <= lastColumn;
}

OusterMetadata readOusterMetadata(const std::filesystem::path& file) {
  const OusterMetadataEntries entries(file);
  OusterMetadata metadata;
  readFormat(entries, metadata);
  readIdentity(entries, metadata);
  readBeams(entries, metadata);
  readBeamOrigin(entries, metadata);
  readTransform(entries, metadata);
  return metadata;
}

}  // namespace toss
