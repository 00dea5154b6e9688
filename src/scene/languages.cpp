#include "scene/languages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>

namespace twrench::scene {
namespace {

constexpr const char* english = "en";

/// A built-in scene with the text of another one in a language other than English.
struct Translation {
  const char* original;
  const char* language;
  const char* name;
};

constexpr std::array translations{Translation{"explain", "nb", "explain-nb"}};

/// The English scene of a translation, or the name itself.
std::string original_of(const std::string& name) {
  const auto* found = std::ranges::find(translations, name, &Translation::name);
  return found == translations.end() ? name : found->original;
}

}  // namespace

std::vector<std::string> languages() {
  std::vector<std::string> codes{english};
  for (const Translation& translation : translations) codes.emplace_back(translation.language);
  return codes;
}

Scene load_scene(const std::string& name, const std::string& language, const std::string& what) {
  if (is_scene_file(name)) {
    throw InvalidArgument(what, name + " has one language, that of its file",
                          fmt::format("leave it out; built-in stories have text in {}",
                                      fmt::join(languages(), " and ")));
  }
  Scene scene = load_scene(name);
  const std::string original = original_of(name);
  std::vector<std::string> known{english};
  if (language == english) return original == name ? scene : load_scene(original);
  for (const Translation& translation : translations) {
    if (translation.original != original) continue;
    if (translation.language == language) return load_scene(translation.name);
    known.emplace_back(translation.language);
  }
  throw InvalidArgument(what, fmt::format("{} has no text in '{}', only in {}", name, language,
                                          fmt::join(known, " and ")));
}

}  // namespace twrench::scene
