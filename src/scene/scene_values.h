#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scene/scene.h"

namespace twrench::scene {

// Changes of a scene by a program, checked as a scene file is. Each throws InvalidArgument about
// the key, and then changes nothing.

/// Sets the field with that key, also in all shots, to a value in the form of scene_json(). The
/// angular velocity, the duration and the speed of a film with shots are each shot's own.
void set_value(Scene& scene, const std::string& key, const nlohmann::ordered_json& value);

/// Replaces the body of a scene without shots.
void set_body(Scene& scene, Body body);

}  // namespace twrench::scene
