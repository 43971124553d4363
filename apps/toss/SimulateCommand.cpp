// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/simulation/SceneCatalogue.h>
#include <toss/simulation/SimulateTo.h>

#include <cstdint>
#include <iostream>
#include <map>
#include <memory>

#include "Command.h"
#include "Progress.h"
#include "WholeNumber.h"

namespace toss {
namespace {

struct SimulateRequest {
  SimulationOptions simulation;
  std::filesystem::path output;
  LogFormat format = LogFormat::Rawlog;
  std::string secondSensor;
  bool list = false, raw = false;
};

void listScenes() {
  for (const SceneInfo& scene : knownScenes())
    std::cout << scene.name << " (" << scene.sensor << ", " << scene.frames
              << " scans): " << scene.description << "\n";
}

void simulate(SimulateRequest& request, bool quiet) {
  if (request.list) return listScenes();
  if (request.simulation.scene.empty() || request.output.empty())
    throw UserError("toss simulate", "a scene and an output are needed",
                    "see toss simulate --list and toss simulate --help");
  request.simulation.compensated = !request.raw;
  Progress progress("simulating", "scans", quiet);
  const SimulatedLog log = simulateTo(
      request.output, request.format, request.simulation,
      [&](int done, int all) {
        progress.update(static_cast<std::uint64_t>(done), static_cast<double>(done) / all);
      },
      request.secondSensor);
  if (quiet) return;
  std::cout << request.output.string() << ": " << log.scans << " scans, " << log.points
            << " returns, " << log.movingPoints << " of them on " << log.movers << " movers\n";
}

}  // namespace

void addSimulateCommand(CLI::App& program, const Verbosity& verbosity) {
  auto request = std::make_shared<SimulateRequest>();
  request->simulation.scene.clear();
  const std::map<std::string, LogFormat> formats = {{"rawlog", LogFormat::Rawlog},
                                                    {"kitti", LogFormat::Kitti}};
  CLI::App* command = program.add_subcommand("simulate", "Make a labelled synthetic log");
  command->footer("Example: toss simulate street street.rawlog --frames 60 --seed 1");
  command->add_option("SCENE", request->simulation.scene, "Name of a scene, see --list");
  command->add_option("OUT", request->output, "The rawlog, or the folder in KITTI layout");
  command->add_option("--frames", request->simulation.frames, "Scans; 0 = the scene's own number");
  command->add_option("--seed", request->simulation.seed, "Seed of all that is random")
      ->check(wholeNumber());
  command->add_option("--sensor", request->simulation.sensor, "Sensor model, such as VLP-16");
  command->add_option("--second-sensor", request->secondSensor,
                      "Model of a second LiDAR on the same robot, none unless given");
  command->add_option("--pose-noise", request->simulation.poseNoise,
                      "Errors of the poses: 0 = none, 1 = as of a good odometry");
  command->add_option("--format", request->format, "rawlog or kitti")
      ->transform(CLI::CheckedTransformer(formats));
  command->add_flag("--raw-sweep", request->raw, "Leave the robot's motion within a sweep in");
  command->add_flag("--list", request->list, "List the scenes");
  command->callback([request, &verbosity] { simulate(*request, verbosity.quiet); });
}

}  // namespace toss
