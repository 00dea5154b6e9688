#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/enumeration.h"
#include "scene/scene.h"

namespace twrench::scene {

/// A word, a sentence or a form with places such as `{}`, in each language, in UTF-8.
class Phrase {
 public:
  /// Does not compile if a text is empty, or if the texts have different numbers of places.
  consteval Phrase(std::string_view en, std::string_view nb) : texts_{en, nb} {
    const auto places = [](std::string_view text) { return std::ranges::count(text, '{'); };
    for (const std::string_view text : texts_) {
      if (text.empty() || places(text) != places(en)) throw "a phrase is incomplete";
    }
  }

  /// Returns the text in a language with the values in its places.
  template <typename... Values>
  std::string in(Language language, const Values&... values) const {
    return fmt::vformat(texts_[static_cast<std::size_t>(language)],
                        fmt::make_format_args(values...));
  }

 private:
  std::array<std::string_view, enumerators<Language>.size()> texts_;
};

}  // namespace twrench::scene
