// SPDX-License-Identifier: BSD-3-Clause
// A real drive: where a sweep ends beside its beginning, the ground makes no step once the scan is
// de-skewed.
#include <InputFixtures.h>
#include <toss/import/OusterImport.h>

#include <algorithm>

namespace toss::test {
namespace {

/// Median step [m] of the ground's height between the first and the last return of each ring, where
/// they lie side by side in the raw scan.
double groundStep(const PosedScan& raw, const PosedScan& scan) {
  std::vector<std::vector<std::size_t>> rings(128);
  for (std::size_t i = 0; i < raw.points.size(); ++i) rings.at(raw.points.ring[i]).push_back(i);
  const auto azimuth = [&](std::size_t i) { return std::atan2(raw.points.y[i], raw.points.x[i]); };
  std::vector<double> steps;
  for (const std::vector<std::size_t>& ring : rings) {
    if (ring.empty()) continue;
    const auto [first, last] = std::minmax_element(
        ring.begin(), ring.end(),
        [&](std::size_t a, std::size_t b) { return raw.points.time[a] < raw.points.time[b]; });
    const float gap = std::remainder(azimuth(*first) - azimuth(*last), 6.2831853f);
    if (std::abs(gap) > 0.03f || raw.points.z[*first] > -1.0f) continue;
    steps.push_back(std::abs(static_cast<double>(scan.points.z[*first] - scan.points.z[*last])));
  }
  EXPECT_GT(steps.size(), 30u);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                   steps.end());
  return steps.at(steps.size() / 2);
}

TEST(DeskewRealDrive, TheGroundClosesBehindTheVehicle) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const fs::path stem = dataFolder() / "ouster/OS-1-128_v2.3.0_1024x10";
  TemporaryFolder folder;
  OusterImportOptions options;
  options.poses = stem.string() + "_lb_n3_poses_kitti.txt";
  importOuster(stem.string() + "_lb_n3.pcap", stem.string() + ".json", folder / "a.rawlog",
               options);
  InputOptions off;
  off.deskew = Deskew::Off;
  const ReadInput raw = readInput(folder / "a.rawlog", off);
  const ReadInput deskewed = readInput(folder / "a.rawlog");
  EXPECT_EQ(deskewed.report.deskewed, 3u);
  // The last scan has no pose behind it.
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT(groundStep(raw.scans.at(i), deskewed.scans.at(i)),
              0.5 * groundStep(raw.scans[i], raw.scans[i]));
}

}  // namespace
}  // namespace toss::test
