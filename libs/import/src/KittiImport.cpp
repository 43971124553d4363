// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/import/KittiImport.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/RawlogWriter.h>

#include <string>
#include <system_error>

namespace toss {
namespace {

/// Writes one scan with its labels where there are some; whether there were.
bool writeScan(const PosedScan& scan, const std::filesystem::path& labels, RawlogWriter& writer) {
  const std::filesystem::path file = labelPath(labels, scan.index);
  std::error_code ignored;
  if (labels.empty() || !std::filesystem::exists(file, ignored)) {
    writer.write(scan);
    return false;
  }
  writer.write(scan, readLabels(file, scan.points.size()));
  return true;
}

}  // namespace

KittiImportResult importKitti(const std::filesystem::path& folder,
                              const std::filesystem::path& rawlog,
                              const KittiImportOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw UserError(folder.string(), "is no folder", "give the folder of one KITTI sequence");
  const auto source = openScans(folder, options.input);
  const std::filesystem::path labels = labelsFolderOf(folder);
  RawlogWriter writer(rawlog, options.gz);
  KittiImportResult result;
  PosedScan scan;
  while (source->next(scan) && scan.index <= options.to) {
    if (scan.index < options.from) continue;
    result.labelled += writeScan(scan, labels, writer);
    if (options.progress) options.progress(source->progress());
  }
  result.scans = writer.scanCount();
  result.input = source->report();
  if (result.scans == 0)
    throw UserError(folder.string(), "holds no scan with a pose in the range that was asked for",
                    "check --from and --to");
  writer.commit();
  return result;
}

}  // namespace toss
