#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace twrench {

/// Returns the background as RGB: the look's flat colour, or the theme's gradient. It is the same
/// in every frame, so it is drawn once.
Image background(const Look& look, int width, int height);

}  // namespace twrench
