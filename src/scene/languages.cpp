#include "scene/languages.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/enumeration.h"

namespace twrench::scene {
namespace {

/// The names of one story in the languages, in the order of Language; empty where it is not told.
using Story = std::array<std::string_view, enumerators<Language>.size()>;

constexpr std::array stories{Story{"explain", "explain-nb"}, Story{"explain-short", ""},
                             Story{"explorer-1", ""}};

}  // namespace

std::string story_in(Language language, const std::string& name, const std::string& what) {
  for (const Story& story : stories) {
    if (std::ranges::find(story, name) == story.end()) continue;
    const std::string_view told = story[static_cast<std::size_t>(language)];
    if (!told.empty()) return std::string(told);
    throw InvalidArgument(what,
                          fmt::format("{} is not told in '{}'", name, enumerator_name(language)),
                          "leave it out, or take the story 'explain'");
  }
  return name;
}

}  // namespace twrench::scene
