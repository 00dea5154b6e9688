#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scene/scene.h"

namespace twrench::scene {

// Changes to a scene by a program, with the same checks as for a scene file. On failure each throws
// InvalidArgument about the key and leaves the scene unchanged.

/// Throws InvalidArgument about `key` if the scene has shots, each of which has its own value.
void require_without_shots(const Scene& scene, const std::string& key);

/// Sets the field with that key, also in all shots, to a value in the form of scene_json(). In a
/// film with shots, the angular velocity, the duration and the speed cannot be set, because each
/// shot has its own.
void set_value(Scene& scene, const std::string& key, const nlohmann::ordered_json& value);

/// Replaces the body of a scene without shots.
void set_body(Scene& scene, Body body);

}  // namespace twrench::scene
