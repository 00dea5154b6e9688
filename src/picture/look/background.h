#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace twrench::picture {

/// Returns the background as RGB: the look's flat colour, or the theme's gradient. It is the same
/// in every frame and therefore drawn once. Without `still_stars` the theme's stars are omitted:
/// for a camera that turns with the body they would have to move.
image::Image background(const scene::Look& look, int width, int height, bool still_stars = true);

}  // namespace twrench::picture
