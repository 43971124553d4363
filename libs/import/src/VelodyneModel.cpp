// SPDX-License-Identifier: BSD-3-Clause
#include "VelodyneModel.h"

#include <mrpt/containers/yaml.h>
#include <toss/geometry/Error.h>
#include <toss/geometry/Options.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace toss {
namespace {

using Calibration = mrpt::obs::VelodyneCalibration;

const std::vector<VelodyneModel>& models() {
  static const std::vector<VelodyneModel> all = {
      {"VLP16", "VLP-16", 16}, {"HDL32", "HDL-32E", 32}, {"HDL64", "HDL-64E", 64}};
  return all;
}

double degrees(double radians) {
  return radians * 180.0 / M_PI;
}

/// A laser of the ROS driver's calibration: angles [rad], distances [m].
Calibration::PerLaserCalib laserOf(const mrpt::containers::yaml& entry) {
  const double vertical = entry["vert_correction"].as<double>();
  const double rotation = entry["rot_correction"].as<double>();
  Calibration::PerLaserCalib laser;
  laser.azimuthCorrection = degrees(rotation);
  laser.verticalCorrection = degrees(vertical);
  laser.distanceCorrection = entry["dist_correction"].as<double>();
  laser.verticalOffsetCorrection = entry["vert_offset_correction"].as<double>();
  laser.horizontalOffsetCorrection = entry["horiz_offset_correction"].as<double>();
  laser.sinVertCorrection = std::sin(vertical);
  laser.cosVertCorrection = std::cos(vertical);
  laser.sinVertOffsetCorrection = laser.sinVertCorrection * laser.verticalOffsetCorrection;
  laser.cosVertOffsetCorrection = laser.cosVertCorrection * laser.verticalOffsetCorrection;
  return laser;
}

/// MRPT's own reader of these files takes the text for the name of a file.
Calibration readYaml(const std::filesystem::path& file) {
  const auto yaml = mrpt::containers::yaml::FromFile(file.string());
  const auto lasers = yaml["lasers"];
  Calibration calibration;
  calibration.laser_corrections.resize(lasers.asSequence().size());
  for (const auto& node : lasers.asSequence()) {
    const mrpt::containers::yaml entry(node);
    calibration.laser_corrections.at(entry["laser_id"].as<std::size_t>()) = laserOf(entry);
  }
  return calibration;
}

/// Keeps MRPT from printing errors that are told in one line below.
class QuietErrors {
 public:
  QuietErrors() : before_(std::cerr.rdbuf(nullptr)) {}
  ~QuietErrors() {
    std::cerr.rdbuf(before_);
    std::cerr.clear();
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  std::streambuf* before_;
};

Calibration readFile(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  const bool yaml = extension == ".yaml" || extension == ".yml";
  try {
    const QuietErrors quiet;
    Calibration calibration = yaml ? readYaml(file) : Calibration();
    if (!yaml) calibration.loadFromXMLFile(file.string());
    if (!calibration.empty()) return calibration;
  } catch (const std::exception&) {
    // Told below: MRPT's words are long and of many lines.
  }
  throw UserError(file.string(), "is no calibration of a Velodyne sensor",
                  "give the maker's .xml, or a .yaml of the ROS driver");
}

}  // namespace

const VelodyneModel& velodyneModelByName(const std::string& name) {
  std::vector<std::string> names;
  for (const VelodyneModel& model : models()) {
    if (model.name == name) return model;
    names.push_back(model.name);
  }
  throw UserError("--model " + name, "is no known model",
                  "did you mean '" + nearestName(name, names) + "'?");
}

std::string modelOfFactoryByte(std::uint8_t value) {
  switch (value) {
    case 0x21:
      return "HDL-32E";
    case 0x22:
      return "VLP-16";
    case 0x23:
      return "Puck LITE";
    case 0x24:
      return "Puck Hi-Res";
    case 0x28:
      return "VLP-32C";
    case 0x31:
      return "Velarray";
    case 0x63:
    case 0xA1:
      return "VLS-128";
    default:
      return "";
  }
}

mrpt::obs::VelodyneCalibration readCalibration(const std::filesystem::path& file,
                                               const VelodyneModel& model) {
  if (file.empty()) {
    // MRPT 2.5.8 has one for the HDL-64E too, but can't read it; each sensor has its own anyway.
    if (model.name == "HDL64")
      throw UserError("--model HDL64", "no two HDL-64E are alike",
                      "give the sensor's own calibration with --calibration FILE.xml or FILE.yaml");
    return Calibration::LoadDefaultCalibration(model.name);
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw UserError(file.string(), "is no file", "give the calibration of the sensor");
  const Calibration calibration = readFile(file);
  const std::size_t lasers = calibration.laser_corrections.size();
  if (lasers != model.lasers)
    throw UserError(file.string(),
                    "describes " + std::to_string(lasers) + " lasers, but --model " + model.name +
                        " has " + std::to_string(model.lasers),
                    "give the calibration of this sensor");
  return calibration;
}

}  // namespace toss
