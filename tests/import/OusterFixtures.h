// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/OusterMetadata.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "CaptureFixtures.h"

/// A made-up Ouster sensor that writes metadata and packets, byte by byte after the manual.
namespace toss::test {

/// What a pixel shows.
struct OusterPixel {
  /// [mm], and as sent; of both returns.
  std::uint32_t range = 0, range2 = 0;
  std::uint16_t reflectivity = 0, reflectivity2 = 0;
};

struct FakeOuster {
  OusterProfile profile = OusterProfile::Rng19Rfl8Sig16Nir16;
  int rows = 8, columns = 512, columnsPerPacket = 16;
  std::uint64_t serialNumber = 122201000998;
  std::uint32_t initializationId = 7109750;
  std::uint16_t port = 7502;
  /// Of the first column of frame 0 [ns]; a frame takes 0.1 s.
  std::uint64_t startTime = 1'650'000'000'000'000'000;
  bool checkSums = false;
  std::function<OusterPixel(int frame, int row, int column)> scene = [](int, int, int) {
    return OusterPixel{10000, 12000, 100, 50};
  };

  bool legacy() const { return profile == OusterProfile::Legacy; }

  std::uint64_t timeOf(int frame, int column) const {
    const auto step = static_cast<std::uint64_t>(100'000'000 / columns);
    return startTime + static_cast<std::uint64_t>(frame) * 100'000'000 +
           static_cast<std::uint64_t>(column) * step;
  }

  /// The metadata with all entries on one level, as of firmware 2.
  nlohmann::json flatMetadata() const {
    std::vector<double> altitudes, azimuths;
    for (int row = 0; row < rows; ++row) {
      altitudes.push_back(15.0 - 30.0 * row / (rows - 1) + (row % 3) * 0.1);
      azimuths.push_back(3.0 - 2.0 * (row % 4));
    }
    return {{"prod_line", "OS-1-8"},
            {"prod_sn", std::to_string(serialNumber)},
            {"initialization_id", initializationId},
            {"build_rev", "v2.3.0"},
            {"udp_port_lidar", 7502},
            {"lidar_mode", std::to_string(columns) + "x10"},
            {"beam_altitude_angles", altitudes},
            {"beam_azimuth_angles", azimuths},
            {"lidar_origin_to_beam_origin_mm", 15.806},
            {"lidar_to_sensor_transform", {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 36.18, 0, 0, 0, 1}},
            {"data_format",
             {{"columns_per_frame", columns},
              {"columns_per_packet", columnsPerPacket},
              {"column_window", {0, columns - 1}},
              {"pixels_per_column", rows},
              {"udp_profile_lidar", nameOf(profile)}}}};
  }

  /// The same in sections, as of firmware 3.
  nlohmann::json sectionedMetadata() const {
    const nlohmann::json flat = flatMetadata();
    nlohmann::json result;
    for (const char* name : {"prod_line", "prod_sn", "initialization_id", "build_rev"})
      result["sensor_info"][name] = flat[name];
    for (const char* name :
         {"beam_altitude_angles", "beam_azimuth_angles", "lidar_origin_to_beam_origin_mm"})
      result["beam_intrinsics"][name] = flat[name];
    result["lidar_intrinsics"]["lidar_to_sensor_transform"] = flat["lidar_to_sensor_transform"];
    for (const char* name : {"lidar_mode", "udp_port_lidar"})
      result["config_params"][name] = flat[name];
    result["lidar_data_format"] = flat["data_format"];
    return result;
  }

  std::string pixelBytes(const OusterPixel& p) const {
    switch (profile) {
      case OusterProfile::Legacy:
        // 20 bits of range below 12 of flags, reflectivity, signal, near infrared, unused.
        return littleBytes(p.range | 0xA5500000u, 4) + littleBytes(p.reflectivity, 2) +
               littleBytes(0x1111, 2) + littleBytes(0x2222, 2) + littleBytes(0, 2);
      case OusterProfile::Rng19Rfl8Sig16Nir16:
        return littleBytes(p.range | 0xF80000u, 4) + littleBytes(p.reflectivity, 1) +
               littleBytes(0, 1) + littleBytes(0x1111, 2) + littleBytes(0x2222, 2) +
               littleBytes(0, 2);
      case OusterProfile::Rng19Rfl8Sig16Nir16Dual:
        return littleBytes(p.range | 0xF80000u, 3) + littleBytes(p.reflectivity, 1) +
               littleBytes(p.range2 | 0xF80000u, 3) + littleBytes(p.reflectivity2, 1) +
               littleBytes(0x1111, 2) + littleBytes(0x1111, 2) + littleBytes(0x2222, 2) +
               littleBytes(0, 2);
      case OusterProfile::Rng15Rfl8Nir8:
        return littleBytes(p.range / 8 | 0x8000u, 2) + littleBytes(p.reflectivity, 1) +
               littleBytes(0x22, 1);
    }
    return "";
  }

  std::string columnBytes(int frame, int column, bool valid) const {
    std::string bytes =
        littleBytes(timeOf(frame, column), 8) + littleBytes(static_cast<std::uint64_t>(column), 2);
    if (legacy())
      bytes += littleBytes(static_cast<std::uint64_t>(frame), 2) +
               littleBytes(static_cast<std::uint64_t>(90112 / columns * column), 4);
    else
      bytes += littleBytes(valid ? 1 : 0, 2);
    for (int row = 0; row < rows; ++row) bytes += pixelBytes(scene(frame, row, column));
    if (legacy()) bytes += littleBytes(valid ? 0xFFFFFFFFu : 0u, 4);
    return bytes;
  }

  /// The payload that starts with `column`.
  std::string packet(int frame, int column, bool valid = true) const {
    std::string bytes;
    if (!legacy())
      bytes = littleBytes(1, 2) + littleBytes(static_cast<std::uint64_t>(frame), 2) +
              littleBytes(initializationId, 3) + littleBytes(serialNumber, 5) +
              std::string(20, '\0');
    for (int i = 0; i < columnsPerPacket; ++i) bytes += columnBytes(frame, column + i, valid);
    if (legacy()) return bytes;
    bytes += std::string(24, '\0');
    return bytes + littleBytes(checkSums ? checkSumOf(bytes) : 0xDEADBEEF0000C0DEu, 8);
  }

  /// CRC-64/XZ, bit by bit (ECMA-182 reflected, all ones before and after).
  static std::uint64_t checkSumOf(const std::string& bytes) {
    std::uint64_t sum = ~std::uint64_t{0};
    for (const char c : bytes) {
      sum ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit)
        sum = (sum >> 1) ^ ((sum & 1u) != 0 ? 0xC96C5795D7870F42u : 0u);
    }
    return ~sum;
  }

  /// Frames of a capture, all packets of `count` frames in their order.
  std::vector<std::string> payloads(int count, int first = 0) const {
    std::vector<std::string> result;
    for (int frame = first; frame < first + count; ++frame)
      for (int column = 0; column < columns; column += columnsPerPacket)
        result.push_back(packet(frame, column));
    return result;
  }

  std::vector<std::string> frames(const std::vector<std::string>& payloadList) const {
    std::vector<std::string> result;
    for (const std::string& payload : payloadList)
      result.push_back(ethernetOf(ipv4Of(udpOf(payload, port))));
    return result;
  }

  std::string capture(int count) const { return pcapOf(frames(payloads(count))); }
};

}  // namespace toss::test
