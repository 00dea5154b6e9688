#include "scene/languages.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/enumeration.h"
#include "base/words.h"

namespace twrench::scene {
namespace {

/// The names of one story in the languages, in the order of Language; empty where it is not told.
using Story = std::array<std::string_view, enumerators<Language>.size()>;

constexpr std::array stories{Story{"explain", "explain-nb"}, Story{"explain-short", ""},
                             Story{"explorer-1", ""}};

/// The part of a tag before the first hyphen, the language.
std::string_view first_subtag(std::string_view tag) { return tag.substr(0, tag.find('-')); }

/// The languages of a story.
std::vector<std::string_view> languages_of(const Story& story) {
  std::vector<std::string_view> names;
  for (const Language language : enumerators<Language>) {
    if (!story[static_cast<std::size_t>(language)].empty()) {
      names.push_back(enumerator_name(language));
    }
  }
  return names;
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_letter_or_digit(char c) { return is_letter(c) || (c >= '0' && c <= '9'); }

/// Returns whether a tag has the form of BCP 47. Its languages of four letters and more are
/// reserved.
bool is_well_formed(std::string_view tag) {
  const std::string_view language = first_subtag(tag);
  if (language.size() < 2 || language.size() > 3 || !std::ranges::all_of(language, is_letter)) {
    return false;
  }
  for (std::size_t at = language.size(); at < tag.size();) {
    const std::string_view subtag = first_subtag(tag.substr(at + 1));
    const bool is_right = !subtag.empty() && subtag.size() <= 8;
    if (!is_right || !std::ranges::all_of(subtag, is_letter_or_digit)) return false;
    at += 1 + subtag.size();
  }
  return true;
}

/// Returns the tag with its language in lower case, and with "nb" for Norwegian in no given form.
std::string checked_tag(const std::string& tag, const std::string& what) {
  if (!is_well_formed(tag)) {
    throw InvalidArgument(what, fmt::format("'{}' is not the tag of a language", tag),
                          "use en or nb or, for captions in another language, a tag of BCP 47, "
                          "such as sv or pt-BR");
  }
  const std::string language = to_lower(first_subtag(tag));
  return (language == "no" ? "nb" : language) + tag.substr(language.size());
}

/// The language of a tag, if the picture has its own words in it.
std::optional<Language> language_of_words(std::string_view tag) {
  const auto found =
      std::ranges::find(enumerators<Language>, first_subtag(tag), &enumerator_name<Language>);
  if (found == enumerators<Language>.end()) return std::nullopt;
  return *found;
}

}  // namespace

void set_language(Scene& scene, const std::string& tag, const std::string& what) {
  scene.language_tag = checked_tag(tag, what);
  scene.language = language_of_words(scene.language_tag).value_or(Language::en);
}

std::string note_on_language(const Scene& scene) {
  if (language_of_words(scene.language_tag)) return {};
  return fmt::format("the picture's own words, such as readouts, are in English, not in '{}'",
                     scene.language_tag);
}

std::string story_in(const std::string& tag, const std::string& name, const std::string& what) {
  const std::string wanted = checked_tag(tag, what);
  for (const Story& story : stories) {
    if (std::ranges::find(story, name) == story.end()) continue;
    const std::optional<Language> language = language_of_words(wanted);
    const std::string_view told = language ? story[static_cast<std::size_t>(*language)] : "";
    if (!told.empty()) return std::string(told);
    throw InvalidArgument(what, fmt::format("{} is not told in '{}'", name, wanted),
                          language ? "leave it out, or take the story 'explain'"
                                   : fmt::format("use {}, or write the captions in a scene file",
                                                 fmt::join(languages_of(story), " or ")));
  }
  return name;
}

}  // namespace twrench::scene
