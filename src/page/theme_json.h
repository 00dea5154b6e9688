#pragma once

#include <nlohmann/json_fwd.hpp>

#include "page/materials.h"

namespace twrench::page {

/// Returns the themes by their names. A theme has the materials of the body's parts, each as the
/// constants of its shaders in GLSL for the look of the scene in that theme, and the colours of the
/// background, the floor and the overlays.
nlohmann::ordered_json themes_json(const scene::Look& look, const Materials& materials);

}  // namespace twrench::page
