#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::scene {

/// Returns the codes of the languages in which built-in stories have text: en, nb.
std::vector<std::string> languages();

/// Loads a scene with captions, title and names of parts in a language. Throws as load_scene(), and
/// InvalidArgument about `what`, listing the languages of the scene, if it has no text in this one.
/// A scene file has a single language.
Scene load_scene(const std::string& name_or_path, const std::string& language,
                 const std::string& what);

}  // namespace twrench::scene
