// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/TracksCsv.h>

#include <nlohmann/json.hpp>

#include "SyntheticRun.h"

namespace toss::test {
namespace {

using Json = nlohmann::ordered_json;

class Report : public testing::Test {
 protected:
  Report() {
    writeTruth(scene_, truth_);
    writeRunLabels(scene_, run_ / "labels", perfect);
  }

  void writeTracks(const fs::path& file, double shift) {
    TracksCsvWriter writer(file);
    for (std::size_t s = 0; s < scene_.scans.size(); ++s) {
      ScanLabels labels;
      labels.scan = s, labels.time = scene_.scans[s].time;
      TrackSample sample;
      sample.track = 1, sample.moving = true;
      sample.box.center.x() = 6.0 + 0.9 * static_cast<double>(s) + shift;
      labels.tracks.push_back(sample);
      writer.add(labels);
    }
    writer.finish();
  }

  TemporaryFolder folder_;
  SyntheticScene scene_;
  fs::path truth_ = folder_ / "truth", run_ = folder_ / "run";
};

TEST_F(Report, IsTheSameBytesEveryTime) {
  EXPECT_EQ(toJson(evaluate(truth_, run_)), toJson(evaluate(truth_, run_)));
  EXPECT_EQ(toText(evaluate(truth_, run_)), toText(evaluate(truth_, run_)));
}

TEST_F(Report, HoldsTheScoresInJson) {
  const Json json = Json::parse(toJson(evaluate(truth_, run_)));
  EXPECT_EQ(json["scans"], 6);
  EXPECT_EQ(json["labels"]["PR"], 100.0);
  EXPECT_EQ(json["labels"]["RR"], 100.0);
  EXPECT_EQ(json["labels"]["removal"]["HA"], 100.0);
  EXPECT_EQ(json["moving"]["iou"], 1.0);
  EXPECT_EQ(json["moving"]["by_class"]["252"]["points"], 600);
  EXPECT_EQ(json["tracking"]["MOTA"], 1.0);
  EXPECT_EQ(json.begin().key(), "truth");
}

TEST_F(Report, WritesNullForWhatIsUndefined) {
  const Json json = Json::parse(toJson(evaluate(truth_, run_)));
  EXPECT_TRUE(json["moving"]["by_range"]["over 60 m"]["recall"].is_null());
  EXPECT_FALSE(json.contains("live_labels"));
}

TEST_F(Report, HoldsTheMainScoresAsText) {
  const std::string text = toText(evaluate(truth_, run_));
  for (const char* part : {"PR [%]", "100.000", "MOTA", "class 252", "perfect labels"}) {
    EXPECT_THAT(text, testing::HasSubstr(part));
  }
}

TEST_F(Report, SummarizesTheTimesOfStages) {
  std::string table = "scan,ground_ms,objects_ms\n";
  for (int i = 1; i <= 20; ++i) {
    table += std::to_string(i - 1) + "," + std::to_string(21 - i) + ",2.5\n";
  }
  writeBytes(run_ / "timings.csv", table);
  const EvaluationReport report = evaluate(truth_, run_);
  ASSERT_EQ(report.stages.size(), 2u);
  EXPECT_EQ(report.stages[0].stage, "ground");
  EXPECT_EQ(report.stages[0].scans, 20u);
  EXPECT_DOUBLE_EQ(report.stages[0].mean, 10.5);
  EXPECT_DOUBLE_EQ(report.stages[0].median, 10.0);
  EXPECT_DOUBLE_EQ(report.stages[0].percentile95, 19.0);
  EXPECT_DOUBLE_EQ(report.stages[0].largest, 20.0);
  EXPECT_DOUBLE_EQ(report.stages[1].mean, 2.5);
}

TEST_F(Report, NamesThreadsAndProcessorWhereTheRunDoes) {
  writeBytes(run_ / "summary.json", R"({"version": "1.2", "threads": 4, "processor": "CPU X"})");
  const EvaluationReport report = evaluate(truth_, run_);
  EXPECT_EQ(report.threads, "4");
  EXPECT_EQ(report.processor, "CPU X");
  EXPECT_EQ(report.version, "1.2");
}

TEST_F(Report, TellsWhatTheRunTook) {
  EXPECT_EQ(toText(evaluate(truth_, run_)).find("The run took"), std::string::npos);
  writeBytes(run_ / "resources.json", R"({"threads": 2, "processor": "CPU Y", "wall_seconds": 4.5,
    "processor_seconds": 8, "scans_per_second": 20, "peak_memory_bytes": 5e8})");
  const EvaluationReport report = evaluate(truth_, run_);
  EXPECT_EQ(report.threads, "2");
  EXPECT_EQ(report.processor, "CPU Y");
  const std::string line =
      "The run took 4.5 s (20.0 scans/s), 8.0 s of processor time, at most 500 MB";
  EXPECT_NE(toText(report).find(line), std::string::npos) << toText(report);
  EXPECT_NE(toJson(report).find("\"peak_memory_bytes\": 500000000"), std::string::npos);
  writeBytes(run_ / "resources.json", "[]");
  EXPECT_THROW(evaluate(truth_, run_), UserError);
}

TEST_F(Report, ScoresBoxesWhereBothSidesHaveThem) {
  EXPECT_FALSE(evaluate(truth_, run_).boxTracking);
  writeTracks(truth_ / "tracks.csv", 0.0);
  EXPECT_FALSE(evaluate(truth_, run_).boxTracking);
  writeTracks(run_ / "tracks.csv", 0.5);
  const EvaluationReport report = evaluate(truth_, run_);
  EXPECT_EQ(report.boxTracking->clear.matches, 6u);
  EXPECT_NEAR(report.boxTracking->clear.precision(), 0.75, 1e-9);
}

}  // namespace
}  // namespace toss::test
