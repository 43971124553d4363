// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <InputFixtures.h>
#include <toss/evaluation/Evaluation.h>
#include <toss/rawlog/InputOptions.h>
#include <toss/rawlog/KittiFolderWriter.h>
#include <toss/rawlog/LabelFile.h>

#include <functional>
#include <random>
#include <vector>

namespace toss::test {

constexpr std::uint32_t kGround = 40, kWall = 50, kCar = 252, kTruck = 258, kPerson = 254;

/// A labelled scene: ground and wall; a car, a truck and a person move, the person with four
/// returns in each scan. Movers keep clear of everything static, so that no voxel holds both.
struct SyntheticScene {
  static constexpr int kScans = 6;
  std::vector<PosedScan> scans;
  std::vector<std::vector<std::uint32_t>> truth;

  /// `start` [m]: where in the map the drive begins.
  explicit SyntheticScene(const Eigen::Vector3d& start = Eigen::Vector3d::Zero()) {
    for (int i = 0; i < kScans; ++i) addScan(i, start);
  }

 private:
  void addScan(int i, const Eigen::Vector3d& start) {
    std::mt19937 random(static_cast<unsigned>(i));
    std::uniform_real_distribution<double> jitter(-0.02, 0.02);
    PosedScan scan;
    scan.index = static_cast<std::uint64_t>(i), scan.time = 0.1 * i;
    scan.mapFromSensor = poseOf(start.x() + 0.3 * i, start.y(), start.z(), 0.05 * i);
    std::vector<std::uint32_t> labels;
    const Eigen::Isometry3d sensorFromMap = scan.mapFromSensor.inverse();
    const auto add = [&](double x, double y, double z, std::uint32_t label) {
      const Eigen::Vector3d jittered(x + jitter(random), y + jitter(random), z + jitter(random));
      const Eigen::Vector3d p = sensorFromMap * (start + jittered);
      scan.points.x.push_back(static_cast<float>(p.x()));
      scan.points.y.push_back(static_cast<float>(p.y()));
      scan.points.z.push_back(static_cast<float>(p.z()));
      scan.points.intensity.push_back(0.5f);
      labels.push_back(label);
    };
    for (int k = 0; k < 60 * 40; ++k) add(4 + 0.2 * (k % 60), -4 + 0.2 * (k / 60), -1.7, kGround);
    for (int k = 0; k < 60 * 10; ++k) add(4 + 0.2 * (k % 60), 5, -1.6 + 0.2 * (k / 60), kWall);
    for (int k = 0; k < 100; ++k) {
      add(6 + 0.9 * i, -1 + 0.15 * (k % 10), -1 + 0.1 * (k / 10), 1u << 16 | kCar);
      add(12 - 0.9 * i, 2 + 0.1 * (k % 10), -1 + 0.1 * (k / 10), 2u << 16 | kTruck);
    }
    for (int k = 0; k < 4; ++k) add(8, -3.5 + 0.5 * i, -1.0 + 0.2 * k, 3u << 16 | kPerson);
    scans.push_back(std::move(scan));
    truth.push_back(std::move(labels));
  }
};

inline void writeTruth(const SyntheticScene& scene, const fs::path& folder) {
  KittiFolderWriter writer(folder);
  for (std::size_t i = 0; i < scene.scans.size(); ++i) writer.write(scene.scans[i], scene.truth[i]);
  writer.commit();
}

/// Label of one return of a run: from scan, return and true label.
using LabelRule = std::function<std::uint32_t(std::size_t, std::size_t, std::uint32_t)>;

inline std::uint32_t naive(std::size_t, std::size_t, std::uint32_t) {
  return label::kStatic;
}
inline std::uint32_t perfect(std::size_t, std::size_t, std::uint32_t truth) {
  return label::isMoving(truth) ? (truth & 0xFFFF0000u) | label::kMoving : label::kStatic;
}

inline void writeRunLabels(const SyntheticScene& scene, const fs::path& folder,
                           const LabelRule& rule) {
  fs::create_directories(folder);
  for (std::size_t s = 0; s < scene.truth.size(); ++s) {
    std::vector<std::uint32_t> labels;
    for (std::size_t i = 0; i < scene.truth[s].size(); ++i) {
      labels.push_back(rule(s, i, scene.truth[s][i]));
    }
    writeLabels(labelPath(folder, s), labels);
  }
}

inline EvaluationReport evaluate(const fs::path& truth, const fs::path& run,
                                 const EvaluationOptions& options = {},
                                 MapErrors* errors = nullptr) {
  return evaluateRun(truth, run, options, InputOptions(), {}, errors);
}

}  // namespace toss::test
