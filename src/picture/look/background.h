#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace twrench::picture {

/// Returns the background as RGB: the look's flat colour, or the theme's gradient. It is the same
/// in every frame and therefore drawn once. Without `still_stars` the theme's stars are omitted,
/// because those around a body are at rest in space, not in the picture: see FixedStars.
image::Image background(const scene::Look& look, int width, int height, bool still_stars = true);

}  // namespace twrench::picture
