#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scene/scene.h"

namespace twrench::scene {

// Changes of a scene by a program, checked as a scene file is. Each throws InvalidArgument about
// the key, and then changes nothing.

/// Sets the field with that key to a value in the form of scene_json().
void set_value(Scene& scene, const std::string& key, const nlohmann::ordered_json& value);

/// Replaces the body.
void set_body(Scene& scene, Body body);

}  // namespace twrench::scene
