#pragma once

#include <hb.h>

#include <string_view>
#include <vector>

#include "canvas/font.h"

namespace twrench::canvas {

/// How characters are set: figures without kerning, raised and lowered ones smaller.
enum class CharacterStyle { plain, figure, raised, lowered };

/// A line of text as its shaping needs it: U+FFFD for each byte that is not part of well-formed
/// UTF-8, a space for each control character, and plain digits and signs for the raised and lowered
/// ones, whose style says what they were.
struct StyledText {
  std::vector<hb_codepoint_t> characters;
  std::vector<CharacterStyle> styles;  ///< one for each
};

StyledText styled(std::string_view utf8);

/// The first `length` characters and an ellipsis.
StyledText shortened(const StyledText& text, std::size_t length);

/// Characters that are shaped at once: of one font, style, script and direction.
struct TextRun {
  std::size_t begin, end;  ///< in the text
  const Font* font;        ///< that of the text or its fallback
  CharacterStyle style;
  hb_script_t script;
  hb_direction_t direction;
};

/// The text's runs from left to right, by the Unicode Bidirectional Algorithm (UAX #9); the line's
/// own direction is that of its first letter. What the font lacks is of its fallback, as
/// choose_fonts() says.
std::vector<TextRun> visual_runs(const StyledText& text, const Font& font);

}  // namespace twrench::canvas
