// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace toss {

/// A file of a folder of scans, and when it was taken [periods].
struct PcdFolderEntry {
  std::filesystem::path file;
  double place = 0.0;
};

/// The PCD files in `folder`, or in pcd/ within it, in order: by number where all are named by
/// whole numbers, else by name. Throws UserError where there are none, or two of one number.
std::vector<PcdFolderEntry> pcdFilesIn(const std::filesystem::path& folder);

}  // namespace toss
