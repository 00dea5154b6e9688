#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "interchange/gltf_scene.h"
#include "scene/scene.h"

namespace twrench::interchange {

/// Writes a Python script that animates an object in Blender: the keys of attitude_track(), with
/// their times in frames of the scene's frame rate. `generator` is the program's name and version.
///
/// Throws as key_times() does, and InvalidArgument about the scene if Blender has not enough frames
/// for it, or not its frame rate.
void write_blender_script(const scene::Scene& scene, const AnimationOptions& options,
                          const std::string& generator,
                          const std::function<void(std::string_view)>& write);

}  // namespace twrench::interchange
