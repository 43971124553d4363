// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/geometry/Options.h>
#include <toss/rawlog/KittiFolderWriter.h>
#include <toss/rawlog/RawlogWriter.h>
#include <toss/rawlog/TracksCsv.h>
#include <toss/simulation/SimulateTo.h>

#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace toss {
namespace {

/// The true boxes of a scan as rows of tracks.csv.
ScanLabels rowsOf(const SimulatedScan& simulated) {
  ScanLabels rows;
  rows.scan = simulated.scan.index;
  rows.time = simulated.scan.time;
  for (const GroundTruthBox& truth : simulated.boxes) {
    rows.tracks.push_back({truth.track, truth.moving, true, truth.box, truth.velocity});
  }
  return rows;
}

/// Sums up the log while it is made.
class Summary {
 public:
  void add(const SimulatedScan& simulated) {
    ++log_.scans;
    log_.points += simulated.labels.size();
    for (const GroundTruthBox& truth : simulated.boxes) {
      if (!truth.moving) continue;
      log_.movingPoints += truth.points;
      movers_.insert(truth.track);
    }
    log_.movers = movers_.size();
  }
  const SimulatedLog& log() const { return log_; }

 private:
  SimulatedLog log_;
  std::set<std::uint16_t> movers_;
};

/// What a second LiDAR on the same robot sees.
SimulationOptions secondOf(const SimulationOptions& first, const std::string& sensor) {
  SimulationOptions second = first;
  second.sensor = sensor;
  second.startTime = first.startTime + 0.05;
  second.robotFromSensor = Eigen::Translation3d(-0.4, 0.0, -0.2) *
                           Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitZ()) *
                           Eigen::AngleAxisd(8.0 * M_PI / 180.0, Eigen::Vector3d::UnitY());
  return second;
}

template <typename Consumer>
SimulatedLog simulate(const SimulationOptions& options, const SimulationProgress& progress,
                      const Consumer& consume, const std::string& secondSensor = "") {
  Simulator simulator(options);
  std::optional<Simulator> second;
  if (!secondSensor.empty()) second.emplace(secondOf(options, secondSensor));
  SimulatedScan simulated;
  Summary summary;
  int frames = 0;
  const auto take = [&] {
    consume(simulated);
    summary.add(simulated);
  };
  while (simulator.next(simulated)) {
    take();
    if (second && second->next(simulated)) {
      // Two of one model need two labels.
      simulated.scan.sensorLabel += "-second";
      take();
    }
    if (progress) progress(++frames, simulator.frames());
  }
  return summary.log();
}

SimulatedLog toRawlog(const std::filesystem::path& output, const SimulationOptions& options,
                      const SimulationProgress& progress, const std::string& secondSensor) {
  constexpr double kFirstTime = 1.6e9;
  std::filesystem::path tracksFile = output;
  tracksFile.replace_filename(output.stem().string() + "_tracks.csv");
  RawlogWriter writer(output);
  TracksCsvWriter tracks(tracksFile);
  std::uint64_t count = 0;
  const auto consume = [&](SimulatedScan& simulated) {
    simulated.scan.time += kFirstTime;
    simulated.scan.index = count++;
    writer.write(simulated.scan, simulated.labels);
    tracks.add(rowsOf(simulated));
  };
  const SimulatedLog log = simulate(options, progress, consume, secondSensor);
  tracks.finish();
  writer.commit();
  return log;
}

SimulatedLog toKitti(const std::filesystem::path& output, const SimulationOptions& options,
                     const SimulationProgress& progress) {
  KittiFolderWriter writer(output);
  std::vector<ScanLabels> rows;
  const SimulatedLog log = simulate(options, progress, [&](const SimulatedScan& simulated) {
    writer.write(simulated.scan, simulated.labels);
    rows.push_back(rowsOf(simulated));
  });
  writer.commit();
  TracksCsvWriter tracks(output / "tracks.csv");
  for (const ScanLabels& row : rows) tracks.add(row);
  tracks.finish();
  return log;
}

}  // namespace

LogFormat logFormatByName(const std::string& name) {
  if (name == "rawlog") return LogFormat::Rawlog;
  if (name == "kitti") return LogFormat::Kitti;
  throw UserError("format '" + name + "'", "unknown",
                  "did you mean '" + nearestName(name, {"rawlog", "kitti"}) + "'?");
}

SimulatedLog simulateTo(const std::filesystem::path& output, LogFormat format,
                        const SimulationOptions& options, const SimulationProgress& progress,
                        const std::string& secondSensor) {
  if (!secondSensor.empty() && (format != LogFormat::Rawlog || options.poseNoise != 0.0))
    throw UserError("second sensor '" + secondSensor + "'", "is for rawlogs with exact poses only",
                    "leave --format and --pose-noise away");
  return format == LogFormat::Rawlog ? toRawlog(output, options, progress, secondSensor)
                                     : toKitti(output, options, progress);
}

}  // namespace toss
