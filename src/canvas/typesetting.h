#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvas/font.h"

namespace twrench::canvas {

/// A typeset line of text: glyphs and their positions. Lengths are in em.
struct Line {
  struct Placed {
    const Font* font;       ///< outlives the line
    unsigned glyph;         ///< of this font
    double x, y;            ///< from the line's left end on the baseline, y down
    double scale;           ///< less than 1 for raised and lowered characters
    std::size_t character;  ///< the first in the text that it represents
  };

  std::vector<Placed> glyphs;  ///< from left to right, except for marks
  double width;
};

/// Shapes the text with HarfBuzz, script by script, in the order of the Unicode Bidirectional
/// Algorithm. Every digit takes the width of the widest one, so that numbers with the same count of
/// digits have the same width and do not jitter; so does U+2007, the blank of a digit. U+2009,
/// which separates thousands, is thin in every font. Raised and lowered digits and signs (x², 10⁻³,
/// ω₁) are made from the font's plain ones, so that all exist and look alike. Characters that the
/// font lacks are taken from its fallback, as choose_fonts() describes.
Line typeset(const Font& font, std::string_view utf8);

/// Does the same, but shortens a text wider than `width` em to its beginning and an ellipsis;
/// returns nothing if not even the ellipsis fits. Never divides the characters of one glyph, or a
/// letter and its marks.
Line typeset_within(const Font& font, std::string_view utf8, double width);

/// Returns the first character of the text that neither the font nor its fallback can draw. Do not
/// call it while another thread draws with these fonts.
std::optional<char32_t> missing_character(const Font& font, std::string_view utf8);

/// Throws MissingGlyph about `what` if there is such a character.
void require_characters(const Font& font, std::string_view utf8, const std::string& what);

}  // namespace twrench::canvas
