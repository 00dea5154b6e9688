#pragma once

#include <string>
#include <vector>

namespace twrench::app {

/// Returns a line for each scene, by name or file: its name, title and motion. The line of a scene
/// with a mistake has the mistake instead.
std::string scene_list(const std::vector<std::string>& names);

}  // namespace twrench::app
