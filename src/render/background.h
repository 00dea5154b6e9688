#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace twrench {

/// What lies behind the body, as RGB: the look's flat colour, or the dark studio's grading. It is
/// the same in every frame, so it is made once.
Image background(const Look& look, int width, int height);

}  // namespace twrench
