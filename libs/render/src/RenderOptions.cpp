// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/RenderOptions.h>

namespace toss {

void RenderOptions::visit(OptionVisitor& visitor) {
  const char* const source = "spec, outputs of toss map";
  visitor.integer({"width", "px", "Width of a picture; rounded down to a multiple of 4", source},
                  width, 160, 7680);
  visitor.integer({"height", "px", "Height of a picture", source}, height, 120, 4320);
  visitor.choice({"color", "", "What the colour of a point tells", source}, color,
                 {"height", "intensity", "class"});
  visitor.choice({"background", "", "What pictures are drawn on", source}, background,
                 {"dark", "light"});
  visitor.real(
      {"point_size", "px",
       "Edge of a drawn point; 0 = so that neighbouring points of the map just touch", source},
      pointSize, 0.0, 50.0);
  visitor.integer({"supersampling", "",
                   "Pictures are drawn that many times larger in each direction, then averaged; "
                   "2 gives smooth edges, 1 is quicker and used above 4096 px",
                   source},
                  supersampling, 1, 2);
  visitor.real({"shading", "",
                "Strength of the shading by depth; larger sets edges apart more, 0 = none", source},
               shading, 0.0, 10.0);
  visitor.integer(
      {"max_points", "",
       "Points drawn in a picture at most; a fixed sample of larger maps is taken", source},
      maxPoints, 1000, 50000000);
  visitor.integer(
      {"scene_max_points", "",
       "Points stored in scene.3Dscene at most; a fixed sample of larger maps is taken", source},
      sceneMaxPoints, 1000, 50000000);
}

}  // namespace toss
