#pragma once

#include <vector>

#include "image/area.h"
#include "scene/scene.h"

namespace twrench {

/// Where things go in the picture.
struct Layout {
  /// A view of one take.
  struct Pane {
    Area area;   ///< all of it; the panes tile the picture
    Area focus;  ///< the part in which the body is to be, uncovered
  };
  std::vector<Pane> panes;
};

Layout layout_of(const Scene& scene);

}  // namespace twrench
