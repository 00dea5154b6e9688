#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvas/font.h"

namespace twrench::canvas {

/// A line of text, set: which glyphs go where. Lengths in em.
struct Line {
  struct Placed {
    const Font* font;       ///< outlives the line
    unsigned glyph;         ///< of this font
    double x, y;            ///< from the line's left end on the baseline, y down
    double scale;           ///< less than 1 for what is raised or lowered
    std::size_t character;  ///< the first of those in the text that it stands for
  };

  std::vector<Placed> glyphs;  ///< from left to right, but for marks
  double width;
};

/// The text shaped by HarfBuzz, script by script, in the order of the Unicode Bidirectional
/// Algorithm. Every digit takes the widest one's room, so that numbers of as many digits are
/// as wide and do not jitter, and so does U+2007, the blank of a digit; U+2009, which parts
/// thousands, is thin in every font. Raised and lowered digits and signs (x², 10⁻³, ω₁) are made
/// from the font's plain ones, so that all are there and alike. What the font lacks is taken from
/// its fallback, as choose_fonts() says.
Line typeset(const Font& font, std::string_view utf8);

/// The same or, where that is wider than `width` em, its beginning with an ellipsis; nothing where
/// not even that has room. What one glyph or a letter with its marks stands for is not cut apart.
Line typeset_within(const Font& font, std::string_view utf8, double width);

/// The first character of the text that neither the font nor its fallback can draw. Not to be
/// called while another thread draws with them.
std::optional<char32_t> missing_character(const Font& font, std::string_view utf8);

/// Throws MissingGlyph about `what` where there is such a character.
void require_characters(const Font& font, std::string_view utf8, const std::string& what);

}  // namespace twrench::canvas
