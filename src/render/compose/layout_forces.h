#pragma once

#include "render/compose/layout.h"

namespace twrench::render {

/// Returns the layout with the legend of the forces, the tilt and the moments as far as the scene
/// shows them, they fit, and the body keeps a third of its pane. Only a single body has them.
Layout with_forces(Layout layout, const scene::Scene& scene);

}  // namespace twrench::render
