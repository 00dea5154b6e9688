#pragma once

#include <string>

#include "scene/scene.h"

namespace twrench::app {

/// Returns the picture of a scene as an <img>. If nothing can be drawn, warns and returns an empty
/// string, because a page works without a picture.
std::string poster_or_nothing(const scene::Scene& scene);

}  // namespace twrench::app
