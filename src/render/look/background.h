#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace twrench::render {

/// Returns the background as RGB: the look's flat colour, or the theme's gradient. It is the same
/// in every frame, so it is drawn once.
image::Image background(const scene::Look& look, int width, int height);

}  // namespace twrench::render
