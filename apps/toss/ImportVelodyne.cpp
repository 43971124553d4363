// SPDX-License-Identifier: BSD-3-Clause
#include <toss/import/VelodyneImport.h>

#include <cmath>
#include <iostream>
#include <memory>

#include "ImportCommands.h"
#include "Progress.h"

namespace toss {
namespace {

struct VelodyneRequest {
  std::filesystem::path capture, output;
  VelodyneImportOptions options;
  /// x y z [m], yaw pitch roll [deg].
  std::vector<double> pose;
};

Eigen::Isometry3d poseOf(const std::vector<double>& values) {
  const auto turn = [&](std::size_t i, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(values[i] * M_PI / 180.0, axis);
  };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << values[0], values[1], values[2];
  pose.linear() = (turn(3, Eigen::Vector3d::UnitZ()) * turn(4, Eigen::Vector3d::UnitY()) *
                   turn(5, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

void importCapture(VelodyneRequest& request, bool quiet) {
  if (!request.pose.empty()) request.options.robotFromSensor = poseOf(request.pose);
  Progress progress("importing", "%", quiet);
  request.options.progress = [&](double share) {
    progress.update(static_cast<std::uint64_t>(100.0 * share), share);
  };
  const VelodyneImportResult result =
      importVelodyne(request.capture, request.output, request.options);
  if (quiet) return;
  std::cout << request.output.string() << ": " << result.scans << " scans of " << result.packets
            << " packets" << (result.dualReturn ? ", two returns per firing" : "") << ", "
            << result.positions << " positions, "
            << (result.satelliteTime ? "satellite time" : "time of capture") << "\n";
  for (const std::string& warning : result.warnings) std::cout << "note: " << warning << "\n";
}

}  // namespace

void addImportVelodyne(CLI::App& import_, const Verbosity& verbosity) {
  auto request = std::make_shared<VelodyneRequest>();
  VelodyneImportOptions& options = request->options;
  CLI::App* command = import_.add_subcommand("velodyne", "Capture of a Velodyne sensor");
  command->footer("Example: toss import velodyne drive.pcap drive.rawlog --model VLP16");
  command->add_option("FILE", request->capture, "Capture, pcap or pcapng")->required();
  command->add_option("OUT", request->output, "The rawlog")->required();
  command->add_option("--model", options.model, "VLP16, HDL32 or HDL64")->required();
  command->add_option("--calibration", options.calibration,
                      "The sensor's own calibration, .xml or .yaml; an HDL64 needs it");
  command->add_option("--port", options.port, "UDP port of the data packets, where several are");
  command->add_option("--source", options.source, "Address of the sensor, where several are");
  command->add_option("--label", options.label, "Sensor label of the scans")->capture_default_str();
  command
      ->add_option("--sensor-pose", request->pose,
                   "Sensor on the robot: x y z [m] yaw pitch roll [degrees]")
      ->expected(6);
  command->add_flag("--gz", options.gz, "Compress");
  command->callback([request, &verbosity] { importCapture(*request, verbosity.quiet); });
}

}  // namespace toss
