#pragma once

#include <string>

#include "scene/scene.h"

namespace twrench::scene {

/// Sets the language of a scene to a tag of BCP 47, such as "sv" or "pt-BR". "no" is "nb". The
/// words of the picture are in English if they are not in that language. Throws InvalidArgument
/// about `what` unless the tag is well formed.
void set_language(Scene& scene, const std::string& tag, const std::string& what);

/// Returns a note if the words of the picture are not in the language of the scene; otherwise
/// nothing.
std::string note_on_language(const Scene& scene);

/// Returns the name of the built-in story that has the captions, the title and the names of the
/// parts of that one in a language; the same name if it is no built-in story. Throws
/// InvalidArgument about `what` if the tag is not well formed, or if the story is not told in that
/// language.
std::string story_in(const std::string& tag, const std::string& name, const std::string& what);

}  // namespace twrench::scene
