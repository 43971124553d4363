// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFolder.h>
#include <toss/rawlog/KittiFolderWriter.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/PoseFile.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "KittiPoints.h"
#include "KittiPoses.h"

namespace toss {
namespace {

void checkFree(const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::exists(folder, error) && !std::filesystem::is_empty(folder, error))
    throw UserError(folder.string(), "exists already and is not empty",
                    "remove it or choose another name");
}

void writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw UserError(file.string(), "can't be written", "check the free space");
}

}  // namespace

struct KittiFolderWriter::Implementation {
  Implementation(const std::filesystem::path& path, const Eigen::Isometry3d& calibration)
      : folder(path), cameraFromLidar(calibration) {
    makeFolder(folder.temporaryPath() / "velodyne");
  }

  AtomicFolder folder;
  Eigen::Isometry3d cameraFromLidar;
  std::string poses, times;
  std::uint64_t scans = 0;
};

KittiFolderWriter::KittiFolderWriter(const std::filesystem::path& folder,
                                     const Eigen::Isometry3d& cameraFromLidar) {
  checkFree(folder);
  implementation_ = std::make_unique<Implementation>(folder, cameraFromLidar);
}

KittiFolderWriter::~KittiFolderWriter() = default;

void KittiFolderWriter::write(const PosedScan& scan) {
  char name[32];
  std::snprintf(name, sizeof name, "%06llu.bin",
                static_cast<unsigned long long>(implementation_->scans));
  writeKittiPoints(implementation_->folder.temporaryPath() / "velodyne" / name, scan.points);
  implementation_->poses +=
      kittiRow(cameraPose(scan.mapFromSensor, implementation_->cameraFromLidar));
  implementation_->times += kittiNumber(scan.time) + "\n";
  ++implementation_->scans;
}

void KittiFolderWriter::write(const PosedScan& scan, const std::vector<std::uint32_t>& labels) {
  if (labels.size() != scan.points.size())
    throw std::logic_error("KittiFolderWriter: one label per point is needed");
  const std::filesystem::path folder = implementation_->folder.temporaryPath() / "labels";
  makeFolder(folder);
  writeLabels(labelPath(folder, implementation_->scans), labels);
  write(scan);
}

std::uint64_t KittiFolderWriter::scanCount() const {
  return implementation_->scans;
}

void KittiFolderWriter::commit() {
  const std::filesystem::path& folder = implementation_->folder.temporaryPath();
  writeText(folder / "poses.txt", implementation_->poses);
  writeText(folder / "calib.txt", "Tr: " + kittiRow(implementation_->cameraFromLidar));
  writeText(folder / "times.txt", implementation_->times);
  implementation_->folder.commit();
}

}  // namespace toss
