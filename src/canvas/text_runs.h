#pragma once

#include <hb.h>

#include <span>
#include <string_view>
#include <vector>

#include "canvas/font.h"

namespace twrench::canvas {

/// Returns the font of each character of a text: `font`, or its fallback for characters that it
/// lacks. A letter and its marks have the same font if one font has them all. All digits have the
/// same font. Spaces and signs that both fonts have take the font of the letters or digits before
/// them; brackets and quotation marks take the font of those after the opening one.
std::vector<const Font*> choose_fonts(std::span<const hb_codepoint_t> text, const Font& font);

hb_script_t script_of(hb_codepoint_t character);

/// Returns whether it is the script of characters that many scripts share: spaces, signs, digits,
/// marks.
bool is_shared(hb_script_t script);

hb_unicode_general_category_t category_of(hb_codepoint_t character);

/// Returns whether the character is set on, under or around the letter before it.
bool is_mark(hb_codepoint_t character);

/// How characters are set: figures without kerning, raised and lowered characters smaller.
enum class CharacterStyle { plain, figure, raised, lowered };

/// A line of text prepared for shaping. Each byte that is not part of well-formed UTF-8 is replaced
/// by U+FFFD, each control character by a space, and raised and lowered characters by plain digits
/// and signs whose style records the original.
struct StyledText {
  std::vector<hb_codepoint_t> characters;
  std::vector<CharacterStyle> styles;  ///< one for each character
};

StyledText styled(std::string_view utf8);

/// Returns the first `length` characters and an ellipsis.
StyledText shortened(const StyledText& text, std::size_t length);

/// Characters that are shaped together: they have the same font, style, script and direction.
struct TextRun {
  std::size_t begin, end;  ///< in the text
  const Font* font;        ///< the font of the text or its fallback
  CharacterStyle style;
  hb_script_t script;
  hb_direction_t direction;
};

/// Returns the text's runs from left to right by the Unicode Bidirectional Algorithm (UAX #9). The
/// direction of the line is that of its first letter. Fonts are those of choose_fonts().
std::vector<TextRun> visual_runs(const StyledText& text, const Font& font);

}  // namespace twrench::canvas
