// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/task_arena.h>
#include <toss/geometry/Error.h>
#include <toss/geometry/SensorModel.h>
#include <toss/simulation/Simulator.h>

#include "GroundTruth.h"
#include "PoseNoise.h"
#include "Random.h"
#include "RayCaster.h"
#include "Scenes.h"
#include "Sweep.h"
#include "World.h"

namespace toss {
namespace {

using namespace simulation;

constexpr double kPeriod = 0.1;

void requireWithin(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw UserError(std::string("simulation: ") + name, "out of range",
                  "give a value from " + std::to_string(static_cast<int>(low)) + " to " +
                      std::to_string(static_cast<int>(high)));
}

const Scene& checkedScene(const SimulationOptions& options) {
  requireWithin("frames", options.frames, 0, 100000);
  requireWithin("pose noise", options.poseNoise, 0, 100);
  requireWithin("threads", options.threads, 0, 1024);
  return findScene(options.scene);
}

World build(const Scene& scene, const SimulationOptions& options) {
  World world;
  RandomStream random(hash(options.seed, 1));
  scene.build(world, random);
  world.carrier.mount = options.robotFromSensor;
  return world;
}

}  // namespace

struct Simulator::Implementation {
  const Scene& scene;
  const SensorModel& sensor;
  SimulationOptions options;
  int frameCount;
  World world;
  GroundTruth truth;
  RayCaster caster;
  PoseNoise poseNoise;
  tbb::task_arena arena;
  SweepReturns returns;
  int frame = 0;

  explicit Implementation(const SimulationOptions& o)
      : scene(checkedScene(o)),
        sensor(sensorByName(o.sensor.empty() ? scene.info.sensor : o.sensor)),
        options(o),
        frameCount(o.frames ? o.frames : scene.info.frames),
        world(build(scene, o)),
        truth(world, kPeriod, frameCount),
        caster(world),
        poseNoise(o.poseNoise, hash(o.seed, 2)),
        arena(o.threads ? o.threads : tbb::task_arena::automatic) {}

  bool next(SimulatedScan& result) {
    if (frame >= frameCount) return false;
    const double time = options.startTime + frame * kPeriod;
    const SweepSettings settings{kPeriod, options.compensated, options.sensorNoise};
    const std::uint64_t key = hash(hash(options.seed, 3), static_cast<std::uint64_t>(frame));
    arena.execute([&] { sweep(world, caster, sensor, settings, time, key, returns); });
    truth.collect(returns, sensor, result);
    truth.listBoxes(time, result.boxes);
    result.trueMapFromSensor = world.mapFromSensor(time);
    result.scan.mapFromSensor = poseNoise.report(result.trueMapFromSensor);
    result.scan.index = static_cast<std::uint64_t>(frame);
    result.scan.time = time;
    result.scan.robotFromSensor = options.robotFromSensor;
    result.scan.sensorModel = sensor.name;
    result.scan.sensorLabel = sensor.name;
    result.scan.motionCompensated = options.compensated;
    ++frame;
    return true;
  }
};

Simulator::Simulator(const SimulationOptions& options)
    : implementation_(std::make_unique<Implementation>(options)) {}
Simulator::~Simulator() = default;

bool Simulator::next(SimulatedScan& result) {
  return implementation_->next(result);
}
int Simulator::frames() const {
  return implementation_->frameCount;
}
const std::string& Simulator::sensorName() const {
  return implementation_->sensor.name;
}

}  // namespace toss
