// SPDX-License-Identifier: BSD-3-Clause
#include "MapRun.h"

#include <tbb/concurrent_queue.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_pipeline.h>
#include <toss/geometry/OptionSections.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/AtomicFolder.h>
#include <toss/rawlog/ScanSource.h>
#include <toss/rawlog/TileFolder.h>
#include <toss/render/RenderUnavailable.h>
#include <toss/render/SceneFile.h>
#include <toss/render/Snapshots.h>

#include <chrono>
#include <deque>
#include <iostream>
#include <optional>

#include "LidarSetup.h"
#include "MapOutputs.h"
#include "MapSummary.h"
#include "OdometryRun.h"
#include "Progress.h"
#include "ResourceReport.h"
#include "ScanRange.h"

namespace toss {
namespace {

/// Labels that are final, with the scan.
struct SettledScan {
  PosedScan scan;
  ScanLabels labels;
};

/// A scan on its way through the program, and what became final with it.
struct Passage {
  /// Whether it is of a scan, as against one of those that are settled at the end.
  bool ofScan = true;
  PosedScan scan;
  FirstStages first;
  double progress = 0.0;
  ScanLabels live;
  Segmentation segmentation;
  std::vector<std::pair<std::string, double>> times;
  std::vector<SettledScan> settled;

  void settle(std::vector<ScanLabels>&& labels) {
    settled.resize(labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) settled[i].labels = std::move(labels[i]);
  }
};

/// The stages of the program around the pipeline: reading, the method in two steps, and the writing
/// of settled scans in three, of which only that of the label files, one each, does not go in
/// order. What is left at the end of the log goes through the last three while the map is written.
class MapRunner {
 public:
  MapRunner(const MapRequest& request, const std::vector<LidarSetup>& lidars,
            const InputOptions& input, bool quiet)
      : request_(request),
        scans_(request.input, input, request.from, request.to),
        settledScans_(request.input, input, request.from, request.to),
        outputs_(request, lidars.front().configuration.render),
        tiles_(request.output / "map_tiles"),
        pipeline_(&tiles_),
        progress_("mapping", "scans", quiet) {
    for (const LidarSetup& lidar : lidars)
      pipeline_.add(lidar.label, lidar.configuration.pipeline, lidar.sensor.model);
    if (!request.liveLabels) pipeline_.skipLiveLabels();
  }

  void run() {
    const auto inOrder = tbb::filter_mode::serial_in_order;
    tbb::parallel_pipeline(
        kScansInFlight,
        tbb::make_filter<void, Item>(inOrder, [&](tbb::flow_control& flow) { return read(flow); }) &
            tbb::make_filter<Item, Item>(inOrder, [&](Item item) { return segment(item); }) &
            tbb::make_filter<Item, Item>(inOrder, [&](Item item) { return process(item); }) &
            writing());
    if (written_ == 0)
      throw UserError(request_.input.string(), "no scan in the chosen range has a pose",
                      "look at it with toss info");
    timed([&] { pipeline_.decideRest(); });
    tbb::parallel_invoke([&] { settleRest(); }, [&] { outputs_.writeStaticMap(pipeline_); });
    outputs_.addRest(rest_);
    outputs_.finish();
  }

  const MapOutputs& outputs() const { return outputs_; }
  const InputReport& inputReport() const { return scans_.report(); }

 private:
  using Item = Passage*;
  static constexpr std::size_t kScansInFlight = 6;

  tbb::filter<Item, void> writing() {
    const auto inOrder = tbb::filter_mode::serial_in_order;
    return tbb::make_filter<Item, Item>(inOrder, [&](Item item) { return readAgain(item); }) &
           tbb::make_filter<Item, Item>(tbb::filter_mode::parallel,
                                        [&](Item item) { return writeLabels(item); }) &
           tbb::make_filter<Item, void>(inOrder, [&](Item item) {
             write(*item);
             spares_.push(item);
           });
  }

  void settleRest() {
    const auto inOrder = tbb::filter_mode::serial_in_order;
    tbb::parallel_pipeline(kScansInFlight,
                           tbb::make_filter<void, Item>(inOrder, [&](tbb::flow_control& flow) {
                             return settleNext(flow);
                           }) & writing());
  }

  Item settleNext(tbb::flow_control& flow) {
    Item item = spareOrNew();
    item->ofScan = false;
    item->settled.resize(1);
    timed([&] {
      if (!pipeline_.settleNext(item->settled.front().labels)) flow.stop();
    });
    return item;
  }

  /// Adds what `work` takes to the time of what is left at the end of the log.
  template <typename Work>
  void timed(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    rest_ +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

  /// Memory fresh from the system costs more than what is written into it.
  Item spareOrNew() {
    Item item = nullptr;
    return spares_.try_pop(item) ? item : &passages_.emplace_back();
  }

  Item read(tbb::flow_control& flow) {
    Item item = spareOrNew();
    if (!scans_.next(item->scan)) flow.stop();
    item->progress = scans_.progress();
    return item;
  }

  Item segment(Item item) {
    pipeline_.segment(item->scan, item->first);
    return item;
  }

  Item process(Item item) {
    const ScanLabels& live = pipeline_.process(item->scan, item->first);
    if (request_.liveLabels) item->live = live;
    if (request_.instances) item->segmentation = pipeline_.segmentedScan().segmentation;
    item->times = pipeline_.stageTimes();
    item->settle(pipeline_.takeSettled());
    return item;
  }

  /// Settled scans are read once more: keeping all scans until their labels are final would need
  /// memory that grows with the voting horizon.
  Item readAgain(Item item) {
    for (SettledScan& settled : item->settled)
      if (!settledScans_.next(settled.scan) || settled.scan.index != settled.labels.scan)
        throw UserError(request_.input.string(), "the input changed while it was read",
                        "map it again when nothing writes to it");
    return item;
  }

  Item writeLabels(Item item) const {
    if (item->ofScan && request_.liveLabels) outputs_.writeLive(item->live);
    if (item->ofScan && request_.instances)
      outputs_.writeInstances(item->scan.index, item->segmentation);
    for (const SettledScan& settled : item->settled) outputs_.writeFinal(settled.labels);
    return item;
  }

  void write(const Passage& item) {
    for (const SettledScan& settled : item.settled)
      outputs_.addSettled(settled.scan, settled.labels, pipeline_.mapOffset());
    if (!item.ofScan) return;
    outputs_.addTimes(item.scan.index, item.times);
    progress_.update(++written_, item.progress);
  }

  const MapRequest& request_;
  ScanRange scans_, settledScans_;
  MapOutputs outputs_;
  TileFolder tiles_;
  MultiLidarPipeline pipeline_;
  Progress progress_;
  std::uint64_t written_ = 0;
  double rest_ = 0.0;
  /// All items. Those that are under way when a stage throws are dropped by TBB, not destroyed.
  std::deque<Passage> passages_;
  /// Items that have gone all the way.
  tbb::concurrent_queue<Item> spares_;
};

void draw(const MapRequest& request, const MapContent& content, const RenderOptions& options) {
  writeScene(content, request.output / "scene.3Dscene", options);
  if (!request.snapshots) return;
  try {
    renderSnapshots(content, request.output / "snapshots", options);
  } catch (const RenderUnavailable& error) {
    std::cerr << "toss: no snapshots: " << error.what() << "\n";
  }
}

}  // namespace

std::string inputName(const MapRequest& request) {
  const std::filesystem::path& path = request.input;
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

namespace {

/// Poses that a run finds before it maps: a file that is put in place when the map is there.
class FoundPoses {
 public:
  FoundPoses(const MapRequest& request, const RunConfiguration& configuration, bool quiet)
      : folder_(request.output), path_(request.output / "poses.txt"), file_(path_) {
    if (!configuration.input.poseFile.empty())
      throw UserError("--odometry", "poses are given too, with --poses or input.pose_file",
                      "leave one of them away");
    const Trajectory found =
        findPoses({request.input, request.from, request.to}, configuration, quiet);
    writeTrajectory(found, PoseFileFormat::Tum, file_.temporaryPath());
    note_ = noteOn(found);
  }

  /// Makes `configuration` use them, while they are unfinished and when they are in place.
  void use(RunConfiguration& configuration) const { use(file_.temporaryPath(), configuration); }
  void commit(RunConfiguration& configuration) {
    file_.commit();
    use(path_, configuration);
  }
  const std::string& note() const { return note_; }

 private:
  static void use(const std::filesystem::path& file, RunConfiguration& configuration) {
    configuration.input.poseFile = file.string();
    configuration.input.poseOf = PoseSubject::Sensor;
    configuration.input.timeOffset = 0.0;
  }

  MadeFolder folder_;
  std::filesystem::path path_;
  AtomicFile file_;
  std::string note_;
};

}  // namespace

void runMap(const MapRequest& request, const Verbosity& verbosity) {
  const int threads = request.threads > 0 ? request.threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const ResourceReport resources(threads);
  RunConfiguration configuration = configure(request.configuration, "");
  std::optional<FoundPoses> found;
  if (request.odometry) found.emplace(request, configuration, verbosity.quiet);
  if (found) found->use(configuration);
  const LidarSelection selection = selectLidars(request.input, configuration.input);
  InputOptions input = configuration.input;
  input.sensorLabels = selection.labels;
  std::vector<LidarSetup> lidars =
      setUpLidars(request.input, request.configuration, selection, input, request.from, request.to);
  configuration = lidars.front().configuration;
  if (lidars.size() == 1) configuration.sensor.model = lidars.front().sensor.name;
  if (found) found->use(configuration);
  MapRunner runner(request, lidars, input, verbosity.quiet);
  runner.run();
  if (found) found->commit(configuration);
  draw(request, runner.outputs().content(), configuration.render);
  for (LidarSetup& lidar : lidars) lidar.configuration.input = configuration.input;
  lidars.front().configuration.sensor = configuration.sensor;
  writeTextAtomically(request.output / "config.ini", configurationText(lidars));
  resources.write(request.output / "resources.json", runner.outputs().counts().scans);
  InputReport report = runner.inputReport();
  report.warnings.insert(report.warnings.end(), selection.notes.begin(), selection.notes.end());
  writeSummary(request, lidars, report, runner.outputs());
  if (verbosity.quiet) return;
  if (found) std::cout << found->note();
  printSummary(request, lidars, report, runner.outputs());
}

}  // namespace toss
