// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Camera.h>
#include <toss/render/MapContent.h>
#include <toss/render/RenderOptions.h>

#include <filesystem>
#include <vector>

namespace toss {

/// The files that renderSnapshots() writes, by their names in the folder.
constexpr const char* kSnapshotNames[] = {"static_top.png", "static_perspective.png",
                                          "removed_top.png", "removed_perspective.png"};

/// Writes the four pictures of a run into `folder`, which is made if it is missing: the static map
/// from above and in perspective, and the same two with what was removed in red and the ways of the
/// moving traces that went somewhere. Same content, same bytes. Throws RenderUnavailable where
/// drawing is impossible, UserError for options out of range and for files that can not be written.
void renderSnapshots(const MapContent& content, const std::filesystem::path& folder,
                     const RenderOptions& options);

/// Writes one picture of everything in `content`, coloured by options.color. Throws as above.
void renderPicture(const MapContent& content, View view, const std::filesystem::path& file,
                   const RenderOptions& options);

/// Points of a cleaned map against ground truth, for the picture of its errors. Map frame, [m].
struct ErrorContent {
  /// Name of the input, for the title.
  std::string name;
  /// Static and kept; moving and removed.
  std::vector<MapPoint> keptStatic, removedMoving;
  /// The errors: moving, but still in the map; static, but removed.
  std::vector<MapPoint> keptMoving, removedStatic;
};

/// Writes the picture of a map's errors: what is static in grey, true removals in green, residues
/// in red, static points lost in blue, errors drawn larger. Throws as renderSnapshots().
void renderErrors(const ErrorContent& content, View view, const std::filesystem::path& file,
                  const RenderOptions& options);

}  // namespace toss
