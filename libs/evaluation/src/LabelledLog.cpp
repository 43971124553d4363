// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/LabelledLog.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/ScanSource.h>
#include <toss/rawlog/SensorRecognition.h>

namespace toss {
namespace {

bool isChosen(std::uint64_t index, const ScanChoice& choice) {
  return index >= choice.from && index <= choice.to && (index - choice.from) % choice.stride == 0;
}

std::string sensorOf(const std::filesystem::path& input, const LabelledLog& log) {
  const std::string sensor = recognizeSensor(log.scans.front());
  if (sensor.empty())
    throw UserError(input.string(), "the sensor is none of those that TOSS knows",
                    "benchmarks need a known sensor; map the log with toss map instead");
  return sensor;
}

}  // namespace

LabelledLog readLabelledLog(const std::filesystem::path& input, const ScanChoice& choice,
                            const InputOptions& options) {
  const std::filesystem::path labels = labelsFolderOf(input);
  if (labels.empty())
    throw UserError(input.string(), "there are no true labels", "put labels/ into the folder");
  if (choice.stride == 0) throw UserError("stride", "is 0", "choose 1 or more");
  LabelledLog log;
  log.name = input.filename().string();
  const std::unique_ptr<ScanSource> source = openScans(input, options);
  PosedScan scan;
  while (source->next(scan) && scan.index <= choice.to) {
    const std::filesystem::path file = labelPath(labels, scan.index);
    if (!isChosen(scan.index, choice) || !std::filesystem::exists(file)) continue;
    log.labels.push_back(readLabels(file, scan.points.size()));
    log.scans.push_back(scan);
  }
  if (log.scans.empty())
    throw UserError(input.string(), "no scan of the chosen range has labels",
                    "look at it with toss info");
  log.sensor = sensorOf(input, log);
  return log;
}

}  // namespace toss
