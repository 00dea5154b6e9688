#pragma once

#include <nlohmann/json.hpp>

#include "page/surface.h"
#include "scene/scene.h"

namespace twrench::page {

/// Returns what the page needs of a scene, which its scripts do not compute: the values of the
/// scene with defaults resolved, the inertia, the surface of its body, the themes with the
/// constants of their shaders, and the limits of what can be set. web/app/page_data.js reads it.
/// The shots of a film that tells a story are left out.
nlohmann::ordered_json page_json(const scene::Scene& scene, const Surface& surface);

}  // namespace twrench::page
