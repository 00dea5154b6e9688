#pragma once

#include <string>

#include "scene/scene.h"

namespace twrench::scene {

/// Returns the name of the built-in story that has the captions, the title and the names of the
/// parts of that one in a language; the same name if it is no built-in story. Throws
/// InvalidArgument about `what` if the story is not told in that language.
std::string story_in(Language language, const std::string& name, const std::string& what);

}  // namespace twrench::scene
