// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toss {

/// One picture of a sheet.
struct SheetEntry {
  /// A PNG or JPEG file.
  std::filesystem::path file;
  /// Written under it; ASCII, longer ones are made smaller until they fit.
  std::string caption;
};

/// Writes the pictures with their captions into one PNG, row by row in a grid of `columns`
/// (at least 1), each scaled to `cellWidth` [px, at least 64] and centred in its cell. Throws
/// UserError where a picture can not be read or the sheet not be written.
void writeContactSheet(const std::vector<SheetEntry>& entries, const std::string& title,
                       int columns, int cellWidth, const std::filesystem::path& file);

}  // namespace toss
