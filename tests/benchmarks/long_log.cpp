// SPDX-License-Identifier: BSD-3-Clause
// Makes a long log of a short one, to measure memory and time of hours: the scans again and again,
// each round where and when the one before has ended, so that the map grows as on a long road.
#include <toss/geometry/Error.h>
#include <toss/rawlog/RawlogWriter.h>
#include <toss/rawlog/ScanSource.h>

#include <cstdlib>
#include <iostream>
#include <optional>

namespace toss {
namespace {

/// Scans of a short log, one after another without an end.
class EndlessScans {
 public:
  explicit EndlessScans(std::filesystem::path input) : input_(std::move(input)) {}

  void next(PosedScan& scan) {
    if (source_ && source_->next(scan)) return place(scan);
    source_ = openScans(input_, InputOptions());
    const std::optional<PosedScan> last = std::exchange(last_, std::nullopt);
    if (!source_->next(scan)) throw UserError(input_.string(), "holds no scans", "give another");
    if (last) {
      timeShift_ = last->time + kPeriod - scan.time;
      shift_ = last->mapFromSensor.translation() - scan.mapFromSensor.translation();
    }
    place(scan);
  }

 private:
  static constexpr double kPeriod = 0.1;

  void place(PosedScan& scan) {
    scan.time += timeShift_;
    scan.mapFromSensor.pretranslate(shift_);
    last_.emplace();
    last_->time = scan.time;
    last_->mapFromSensor = scan.mapFromSensor;
  }

  std::filesystem::path input_;
  std::unique_ptr<ScanSource> source_;
  std::optional<PosedScan> last_;
  double timeShift_ = 0.0;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
};

void writeLongLog(const char* input, const char* output, std::uint64_t count) {
  EndlessScans scans(input);
  RawlogWriter writer(output);
  PosedScan scan;
  while (writer.scanCount() < count) {
    scans.next(scan);
    writer.write(scan);
  }
  writer.commit();
}

}  // namespace
}  // namespace toss

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: long_log SHORT.rawlog LONG.rawlog SCANS\n";
    return 1;
  }
  try {
    toss::writeLongLog(argv[1], argv[2], std::strtoull(argv[3], nullptr, 10));
  } catch (const std::exception& error) {
    std::cerr << "long_log: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
