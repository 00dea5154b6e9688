#pragma once

#include <nlohmann/json_fwd.hpp>

#include "motion/recorded_motion.h"
#include "page/surface.h"
#include "scene/scene.h"

namespace twrench::page {

/// Returns the data of a scene that the page's scripts need but do not compute: the values of the
/// scene with defaults resolved, the inertia, the surface of its body, the themes with the
/// constants of their shaders, and the limits of the settings. web/app/page_data.js reads it. The
/// shots of a film are omitted. `recording` is what the page plays of the scene's recorded motion;
/// null if the scene has none.
nlohmann::ordered_json page_json(const scene::Scene& scene, const Surface& surface,
                                 const motion::RecordedMotion* recording = nullptr);

}  // namespace twrench::page
