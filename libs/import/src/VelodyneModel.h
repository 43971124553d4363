// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/VelodyneCalibration.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace toss {

/// A model whose packets MRPT can decode.
struct VelodyneModel {
  /// As --model and MRPT name it, "VLP16", and as the maker does, "VLP-16".
  std::string name, sensor;
  /// Lasers of the sensor.
  std::size_t lasers = 0;
};

/// The model of that name. Throws UserError naming the nearest known one.
const VelodyneModel& velodyneModelByName(const std::string& name);

/// The name of the model that the last byte of a data packet stands for (VLP-16 user manual,
/// "factory bytes"), "" where it stands for none: an HDL-64E has other things there.
std::string modelOfFactoryByte(std::uint8_t value);

/// Reads the calibration of a sensor, or MRPT's own for the model where `file` is empty. Throws
/// UserError where there is none, or the file is damaged or is that of a sensor with another number
/// of lasers.
mrpt::obs::VelodyneCalibration readCalibration(const std::filesystem::path& file,
                                               const VelodyneModel& model);

}  // namespace toss
