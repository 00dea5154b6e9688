#include "canvas/font_choice.h"

#include <algorithm>

#include "canvas/text_runs.h"

namespace twrench::canvas {
namespace {

/// Returns whether it is a joiner, a soft hyphen or the like, which HarfBuzz omits if the font has
/// none.
bool is_unseen(hb_codepoint_t character) {
  return category_of(character) == HB_UNICODE_GENERAL_CATEGORY_FORMAT;
}

bool is_opening(hb_codepoint_t character) {
  const auto category = category_of(character);
  return category == HB_UNICODE_GENERAL_CATEGORY_OPEN_PUNCTUATION ||
         category == HB_UNICODE_GENERAL_CATEGORY_INITIAL_PUNCTUATION;
}

bool is_closing(hb_codepoint_t character) {
  const auto category = category_of(character);
  return category == HB_UNICODE_GENERAL_CATEGORY_CLOSE_PUNCTUATION ||
         category == HB_UNICODE_GENERAL_CATEGORY_FINAL_PUNCTUATION;
}

/// A letter, a digit or a sign, with the marks on it.
struct Cluster {
  std::span<const hb_codepoint_t> characters;
  const Font* font;  ///< null until one is chosen
};

std::vector<Cluster> clusters_of(std::span<const hb_codepoint_t> text) {
  std::vector<Cluster> clusters;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    end = begin + 1;
    while (end < text.size() && (is_mark(text[end]) || is_unseen(text[end]))) ++end;
    clusters.push_back({text.subspan(begin, end - begin), nullptr});
  }
  return clusters;
}

/// Returns the number of characters before the first that the font lacks, both as they are and
/// composed.
std::size_t count_in(const Font& font, std::span<const hb_codepoint_t> characters) {
  hb_codepoint_t composed = 0;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    hb_codepoint_t both = 0;
    if (hb_unicode_compose(hb_unicode_funcs_get_default(), composed, characters[i], &both) != 0 &&
        font.has(both)) {
      composed = both;
    } else if (font.has(characters[i]) || is_unseen(characters[i])) {
      composed = characters[i];
    } else {
      return i;
    }
  }
  return characters.size();
}

/// Divides a text between a font and its fallback, as choose_fonts() describes.
class FontChoice {
 public:
  FontChoice(std::span<const hb_codepoint_t> text, const Font& font)
      : font_(font), clusters_(clusters_of(text)) {
    choose_for_letters_and_digits();
    choose_for_opening_brackets();
    choose_for_other_signs();
  }

  /// Returns one font for each character.
  std::vector<const Font*> fonts() const {
    std::vector<const Font*> fonts;
    for (const auto& [characters, font] : clusters_) {
      const Font* other = other_than(font);
      const std::size_t count = count_in(*font, characters);
      for (std::size_t i = 0; i < characters.size(); ++i) {
        const bool strange = i >= count && !font->has(characters[i]) && other->has(characters[i]);
        fonts.push_back(strange ? other : font);
      }
    }
    return fonts;
  }

 private:
  const Font* other_than(const Font* font) const {
    return font == &font_ ? font_.fallback() : &font_;
  }

  void choose(Cluster& cluster, const Font* preferred) {
    const Font* other = other_than(preferred);
    const bool more =
        count_in(*other, cluster.characters) > count_in(*preferred, cluster.characters);
    cluster.font = more ? other : preferred;
  }

  void choose_for_letters_and_digits() {
    for (Cluster& cluster : clusters_) {
      const hb_codepoint_t first = cluster.characters.front();
      if (first >= U'0' && first <= U'9') {
        choose(cluster, &font_.digits());
      } else if (!is_shared(script_of(first))) {
        choose(cluster, &font_);
      }
    }
  }

  void choose_for_opening_brackets() {
    const Font* after = &font_;
    for (auto cluster = clusters_.rbegin(); cluster != clusters_.rend(); ++cluster) {
      if (cluster->font != nullptr) {
        after = cluster->font;
      } else if (is_opening(cluster->characters.front())) {
        choose(*cluster, after);
      }
    }
  }

  void choose_for_other_signs() {
    const auto first = std::ranges::find_if(clusters_, [](const Cluster& c) { return c.font; });
    const Font* before = first == clusters_.end() ? &font_ : first->font;
    std::vector<const Font*> open;  // the fonts of brackets that are still open
    for (Cluster& cluster : clusters_) {
      const hb_codepoint_t sign = cluster.characters.front();
      if (is_opening(sign)) {
        open.push_back(cluster.font);
      } else if (is_closing(sign) && !open.empty()) {
        choose(cluster, open.back());
        open.pop_back();
      } else if (cluster.font != nullptr) {
        before = cluster.font;
      } else {
        choose(cluster, before);
      }
    }
  }

  const Font& font_;
  std::vector<Cluster> clusters_;
};

}  // namespace

std::vector<const Font*> choose_fonts(std::span<const hb_codepoint_t> text, const Font& font) {
  if (font.fallback() == nullptr) return std::vector<const Font*>(text.size(), &font);
  return FontChoice(text, font).fonts();
}

}  // namespace twrench::canvas
