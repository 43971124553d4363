// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/MapContent.h>
#include <toss/render/RenderOptions.h>

#include <filesystem>

namespace toss {

/// Writes a .3Dscene that MRPT's SceneViewer3D opens: the static map coloured by height, the
/// removed points in red, the trajectory, and the moving traces as boxes and paths, each a named
/// object. Needs no graphics. Maps larger than options.sceneMaxPoints are thinned. Throws UserError
/// where the file can not be written.
void writeScene(const MapContent& content, const std::filesystem::path& file,
                const RenderOptions& options);

}  // namespace toss
