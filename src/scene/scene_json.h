#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace twrench::scene {

/// Returns every value of the scene with defaults resolved, using the keys and units of a scene
/// file.
nlohmann::ordered_json scene_json(const Scene& scene);

}  // namespace twrench::scene
