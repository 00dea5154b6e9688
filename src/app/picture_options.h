#pragma once

#include "app/scene_options.h"

namespace twrench {

/// Adds the options for what is drawn and how: size, theme, views, overlays, camera.
void add_picture_options(SceneOptions& scene);

}  // namespace twrench
