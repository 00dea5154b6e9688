#include "canvas/text_runs.h"

#include <fribidi.h>

#include <algorithm>
#include <memory>
#include <new>
#include <numeric>
#include <string>

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

hb_script_t script_of(hb_codepoint_t character) {
  return hb_unicode_script(hb_unicode_funcs_get_default(), character);
}

bool is_shared(hb_script_t script) {
  return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN;
}

hb_unicode_general_category_t category_of(hb_codepoint_t character) {
  return hb_unicode_general_category(hb_unicode_funcs_get_default(), character);
}

bool is_mark(hb_codepoint_t character) {
  switch (category_of(character)) {
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
      return true;
    default:
      return false;
  }
}

namespace {

struct StyledCharacter {
  hb_codepoint_t character;
  CharacterStyle style;
};

StyledCharacter styled(hb_codepoint_t character) {
  constexpr std::u32string_view superscripts = U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", subscripts = U"₀₁₂₃₄₅₆₇₈₉₊₋";
  constexpr std::u32string_view plains = U"0123456789+−";
  constexpr hb_codepoint_t figure_space = 0x2007;
  if (const auto i = superscripts.find(character); i != std::u32string_view::npos) {
    return {plains[i], CharacterStyle::raised};
  }
  if (const auto i = subscripts.find(character); i != std::u32string_view::npos) {
    return {plains[i], CharacterStyle::lowered};
  }
  const bool control = character < 0x20 || (character >= 0x7F && character < 0xA0);
  if (control) return {U' ', CharacterStyle::plain};
  const bool figure = (character >= U'0' && character <= U'9') || character == figure_space;
  return {character, figure ? CharacterStyle::figure : CharacterStyle::plain};
}

/// The level (UAX #9) of each character, and the character at each place on the line from left to
/// right.
struct BidiOrder {
  std::vector<FriBidiLevel> levels;
  std::vector<FriBidiStrIndex> characters;
};

BidiOrder bidi_order(const std::vector<FriBidiChar>& text) {
  const auto length = static_cast<FriBidiStrIndex>(text.size());
  BidiOrder order{std::vector<FriBidiLevel>(text.size()),
                  std::vector<FriBidiStrIndex>(text.size())};
  std::iota(order.characters.begin(), order.characters.end(), 0);
  std::vector<FriBidiCharType> types(text.size());
  fribidi_get_bidi_types(text.data(), length, types.data());
  if (std::ranges::none_of(types, [](auto type) { return FRIBIDI_IS_RTL(type) != 0; })) {
    return order;  // as for most lines, which cost no more
  }
  std::vector<FriBidiBracketType> brackets(text.size());
  fribidi_get_bracket_types(text.data(), length, types.data(), brackets.data());
  FriBidiParType direction = FRIBIDI_PAR_ON;
  if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), length, &direction,
                                          order.levels.data()) == 0 ||
      fribidi_reorder_line(0, types.data(), length, 0, direction, order.levels.data(), nullptr,
                           order.characters.data()) == 0) {
    throw std::bad_alloc();
  }
  return order;
}

/// The script of each character. A character that many scripts share has the script of the letters
/// before it.
std::vector<hb_script_t> scripts_of(const std::vector<hb_codepoint_t>& text) {
  std::vector<hb_script_t> scripts(text.size());
  std::ranges::transform(text, scripts.begin(), script_of);
  const auto first = std::ranges::find_if_not(scripts, is_shared);
  hb_script_t script = first == scripts.end() ? HB_SCRIPT_COMMON : *first;
  for (hb_script_t& own : scripts) {
    if (is_shared(own)) own = script;
    script = own;
  }
  return scripts;
}

}  // namespace

StyledText styled(std::string_view utf8) {
  const std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)> decoder(hb_buffer_create(),
                                                                           &hb_buffer_destroy);
  hb_buffer_add_utf8(decoder.get(), utf8.data(), static_cast<int>(utf8.size()), 0, -1);
  if (!hb_buffer_allocation_successful(decoder.get())) throw std::bad_alloc();
  unsigned count = 0;
  const hb_glyph_info_t* decoded = hb_buffer_get_glyph_infos(decoder.get(), &count);
  StyledText text;
  text.characters.reserve(count);
  text.styles.reserve(count);
  for (unsigned i = 0; i < count; ++i) {
    const auto [character, style] = styled(decoded[i].codepoint);
    text.characters.push_back(character);
    text.styles.push_back(i > 0 && is_mark(character) ? text.styles.back() : style);
  }
  return text;
}

StyledText shortened(const StyledText& text, std::size_t length) {
  const auto count = static_cast<std::ptrdiff_t>(length);
  StyledText some{{text.characters.begin(), text.characters.begin() + count},
                  {text.styles.begin(), text.styles.begin() + count}};
  some.characters.push_back(U'…');
  some.styles.push_back(CharacterStyle::plain);
  return some;
}

std::vector<TextRun> visual_runs(const StyledText& text, const Font& font) {
  const BidiOrder order = bidi_order(text.characters);
  const std::vector<hb_script_t> scripts = scripts_of(text.characters);
  const std::vector<const Font*> fonts = choose_fonts(text.characters, font);
  const auto same = [&](std::size_t a, std::size_t b) {
    return fonts[a] == fonts[b] && text.styles[a] == text.styles[b] && scripts[a] == scripts[b] &&
           order.levels[a] == order.levels[b];
  };
  std::vector<TextRun> runs;
  for (std::size_t place = 0; place < text.characters.size();) {
    const auto here = static_cast<std::size_t>(order.characters[place]);
    std::size_t begin = here, end = here + 1;
    while (begin > 0 && same(begin - 1, here)) --begin;
    while (end < text.characters.size() && same(end, here)) ++end;
    const bool to_left = FRIBIDI_LEVEL_IS_RTL(order.levels[here]) != 0;
    runs.push_back({begin, end, fonts[here], text.styles[here], scripts[here],
                    to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR});
    place += end - begin;
  }
  return runs;
}

}  // namespace twrench::canvas
