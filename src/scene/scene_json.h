#pragma once

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace twrench {

/// Every value of the scene, defaults resolved, in the words and units of a scene file.
nlohmann::ordered_json scene_json(const Scene& scene);

}  // namespace twrench
