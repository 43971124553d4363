// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/task_arena.h>
#include <toss/geometry/Error.h>
#include <toss/geometry/SensorModel.h>
#include <toss/simulation/Simulator.h>

#include <algorithm>

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

World build(const Scene& scene, std::uint64_t seed) {
  World world;
  RandomStream random(hash(seed, 1));
  scene.build(world, random);
  return world;
}

}  // namespace

struct Simulator::Implementation {
  const Scene& scene;
  const SensorModel& sensor;
  SimulationOptions options;
  int frameCount;
  World world;
  RayCaster caster;
  PoseNoise poseNoise;
  tbb::task_arena arena;
  /// Whether each mover moves within the log.
  std::vector<bool> moves;
  SweepReturns returns;
  /// Returns per instance in the present scan.
  std::vector<std::uint32_t> counts;
  int frame = 0;

  explicit Implementation(const SimulationOptions& o)
      : scene(checkedScene(o)),
        sensor(sensorByName(o.sensor.empty() ? scene.info.sensor : o.sensor)),
        options(o),
        frameCount(o.frames ? o.frames : scene.info.frames),
        world(build(scene, o.seed)),
        caster(world),
        poseNoise(o.poseNoise, hash(o.seed, 2)),
        arena(o.threads ? o.threads : tbb::task_arena::automatic) {
    for (const Mover& mover : world.movers) {
      moves.push_back(world.movesWithin(mover, 0.0, kPeriod, frameCount));
    }
  }

  std::uint16_t labelOf(std::size_t mover) const {
    const Figure& figure = world.movers[mover].figure;
    return moves[mover] ? figure.movingLabel : figure.stillLabel;
  }

  /// Labels of the movers' parts are those of the whole mover.
  std::vector<std::uint16_t> labelOfInstance() const {
    std::vector<std::uint16_t> labels(world.stillObjects.size() + world.movers.size() + 1, 0);
    for (const auto& object : world.stillObjects) labels[object.instance] = object.label;
    for (std::size_t i = 0; i < world.movers.size(); ++i) {
      labels[world.movers[i].instance] = labelOf(i);
    }
    return labels;
  }

  /// Appends what came back to scan and labels.
  void collect(SimulatedScan& result) {
    const std::vector<std::uint16_t> labels = labelOfInstance();
    counts.assign(labels.size(), 0);
    PointCloud& points = result.scan.points;
    points.resize(0);
    result.labels.clear();
    for (std::size_t i = 0; i < returns.beams.size(); ++i) {
      const BeamReturn& beam = returns.beams[i];
      if (beam.range <= 0.0) continue;
      const int column = static_cast<int>(i) % sensor.columns;
      points.x.push_back(returns.points[i].x());
      points.y.push_back(returns.points[i].y());
      points.z.push_back(returns.points[i].z());
      points.intensity.push_back(beam.intensity);
      points.ring.push_back(static_cast<std::uint16_t>(static_cast<int>(i) / sensor.columns));
      points.time.push_back(static_cast<float>(columnTime(column, sensor.columns, kPeriod)));
      const std::uint32_t label = beam.instance ? labels[beam.instance] : beam.label;
      result.labels.push_back(label | static_cast<std::uint32_t>(beam.instance) << 16);
      ++counts[beam.instance];
    }
  }

  void listBoxes(double time, SimulatedScan& result) const {
    result.boxes.clear();
    const std::vector<std::uint16_t> labels = labelOfInstance();
    result.boxes.resize(labels.size());
    for (const auto& object : world.stillObjects) {
      result.boxes[object.instance] = {
          object.instance,         object.label,           false, object.box,
          Eigen::Vector3d::Zero(), counts[object.instance]};
    }
    for (std::size_t i = 0; i < world.movers.size(); ++i) {
      const Mover& mover = world.movers[i];
      const Eigen::Isometry3d before = world.poseOf(mover, time - 0.5 * kPeriod);
      const Eigen::Isometry3d after = world.poseOf(mover, time + 0.5 * kPeriod);
      result.boxes[mover.instance] = {mover.instance,
                                      labelOf(i),
                                      moves[i],
                                      boxOf(mover.figure, world.poseOf(mover, time)),
                                      (after.translation() - before.translation()) / kPeriod,
                                      counts[mover.instance]};
    }
    const auto unseen = [](const GroundTruthBox& box) { return box.track == 0 || box.points == 0; };
    result.boxes.erase(std::remove_if(result.boxes.begin(), result.boxes.end(), unseen),
                       result.boxes.end());
  }

  bool next(SimulatedScan& result) {
    if (frame >= frameCount) return false;
    const double time = frame * kPeriod;
    const SweepSettings settings{kPeriod, options.compensated, options.sensorNoise};
    const std::uint64_t key = hash(hash(options.seed, 3), static_cast<std::uint64_t>(frame));
    arena.execute([&] { sweep(world, caster, sensor, settings, time, key, returns); });
    collect(result);
    listBoxes(time, result);
    result.trueMapFromSensor = world.mapFromSensor(time);
    result.scan.mapFromSensor = poseNoise.report(result.trueMapFromSensor);
    result.scan.index = static_cast<std::uint64_t>(frame);
    result.scan.time = time;
    result.scan.sensorModel = sensor.name;
    result.scan.sensorLabel = "LIDAR";
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
