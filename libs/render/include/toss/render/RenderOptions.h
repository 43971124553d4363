// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// What the colour of a point tells.
enum class PictureColor {
  Height,     ///< height above the map's low ground
  Intensity,  ///< mean intensity
  Class       ///< static or moving
};

/// What pictures are drawn on.
enum class Background { Dark, Light };

/// How pictures and the scene file are made.
struct RenderOptions : Options {
  /// Size of a picture [px]; the width is a multiple of 4.
  int width = 1920, height = 1080;
  PictureColor color = PictureColor::Height;
  Background background = Background::Dark;
  /// Edge of a drawn point [px]; 0 = so that neighbouring points of the map just touch.
  double pointSize = 0.0;
  /// Pictures are drawn that many times larger in each direction, then averaged.
  int supersampling = 2;
  /// Strength of the shading by depth that sets edges apart; 0 = none.
  double shading = 1.0;
  /// Points drawn in a picture, and stored in scene.3Dscene, at most; a fixed sample of larger maps
  /// is taken.
  int maxPoints = 4000000, sceneMaxPoints = 2000000;

  const char* section() const override { return "render"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
