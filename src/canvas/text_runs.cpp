#include "canvas/text_runs.h"

#include <fribidi.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <string>

#include "canvas/font_choice.h"

namespace twrench::canvas {

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
