// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/FormatText.h>
#include <toss/rawlog/InputSummary.h>
#include <toss/rawlog/ScanSource.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "InputStream.h"
#include "SummaryParts.h"

namespace toss {
namespace {

std::uint64_t countLabelFiles(const std::filesystem::path& input) {
  const std::filesystem::path folder = labelsFolderOf(input);
  if (folder.empty()) return 0;
  std::uint64_t count = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    count += entry.path().extension() == ".label";
  return count;
}

std::string lineOf(const StreamSummary& stream) {
  std::string line =
      "  '" + stream.label + "' " + stream.className + ": " + std::to_string(stream.count);
  if (stream.rate() > 0.0)
    line += format(", %.2f Hz, %.3f to %.3f s", stream.rate(), stream.firstTime, stream.lastTime);
  if (stream.pointClouds)
    line += format(", %llu to %llu points, sensor %s",
                   static_cast<unsigned long long>(stream.fewestPoints),
                   static_cast<unsigned long long>(stream.mostPoints),
                   stream.sensorModel.empty() ? "unknown" : stream.sensorModel.c_str());
  return line + "\n";
}

nlohmann::json jsonOf(const StreamSummary& stream) {
  nlohmann::json json = {{"label", stream.label},        {"class", stream.className},
                         {"count", stream.count},        {"first_time", stream.firstTime},
                         {"last_time", stream.lastTime}, {"rate", stream.rate()}};
  if (stream.pointClouds) {
    json["points"] = stream.points;
    json["fewest_points"] = stream.fewestPoints;
    json["most_points"] = stream.mostPoints;
    json["sensor_model"] = stream.sensorModel;
  }
  return json;
}

nlohmann::json jsonOf(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

void addPosition(const Eigen::Vector3d& position, InputSummary& summary) {
  if (!summary.lastPosition) summary.lowest = summary.highest = position;
  if (summary.lastPosition) summary.pathLength += (position - *summary.lastPosition).norm();
  summary.lowest = summary.lowest.cwiseMin(position);
  summary.highest = summary.highest.cwiseMax(position);
  summary.lastPosition = position;
}

InputSummary summarizeInput(const std::filesystem::path& input, const InputOptions& options) {
  options.check();
  InputSummary summary;
  summary.path = input;
  std::error_code ignored;
  if (std::filesystem::is_directory(input, ignored)) {
    summary.format = "KITTI folder";
    summarizeKittiFolder(options, summary);
  } else {
    InputStream stream(input);
    summary.format = stream.compressed() ? "rawlog (gz)" : "rawlog";
    summary.bytes = stream.getTotalBytesCount();
    summarizeRawlog(options, summary);
  }
  summary.labelFiles = countLabelFiles(input);
  return summary;
}

std::string toText(const InputSummary& summary) {
  std::string text = summary.path.string() + ": " + summary.format +
                     format(", %.1f MB\n", static_cast<double>(summary.bytes) * 1e-6);
  for (const StreamSummary& stream : summary.streams) text += lineOf(stream);
  text += format("scans: %llu, of them without a pose: %llu\n",
                 static_cast<unsigned long long>(summary.scans),
                 static_cast<unsigned long long>(summary.scansWithoutPose));
  text += format("poses: %llu, path %.1f m", static_cast<unsigned long long>(summary.poses),
                 summary.pathLength);
  if (summary.poses > 0)
    text += format(", x %.1f to %.1f, y %.1f to %.1f, z %.1f to %.1f m", summary.lowest.x(),
                   summary.highest.x(), summary.lowest.y(), summary.highest.y(), summary.lowest.z(),
                   summary.highest.z());
  text += format("\nlabels: %llu files\n", static_cast<unsigned long long>(summary.labelFiles));
  for (const std::string& warning : summary.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string toJson(const InputSummary& summary) {
  nlohmann::json json = {{"path", summary.path.string()},
                         {"format", summary.format},
                         {"bytes", summary.bytes},
                         {"scans", summary.scans},
                         {"scans_without_pose", summary.scansWithoutPose},
                         {"poses", summary.poses},
                         {"path_length", summary.pathLength},
                         {"lowest", jsonOf(summary.lowest)},
                         {"highest", jsonOf(summary.highest)},
                         {"label_files", summary.labelFiles},
                         {"warnings", summary.warnings},
                         {"streams", nlohmann::json::array()}};
  for (const StreamSummary& stream : summary.streams) json["streams"].push_back(jsonOf(stream));
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace toss
