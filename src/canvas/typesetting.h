#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "canvas/font.h"

namespace twrench {

/// A line of text, set: which glyphs go where. Lengths in em.
struct Line {
  struct Placed {
    int glyph;
    double x, y;   ///< from the line's start on the baseline, y down
    double scale;  ///< less than 1 for what is raised or lowered
  };

  const Font* font;  ///< outlives the line
  std::vector<Placed> glyphs;
  double width;
};

/// The text with its pairs kerned. Every digit takes the widest one's room, so that numbers of as
/// many digits are as wide and do not jitter. Raised and lowered digits and signs (x², 10⁻³, ω₁)
/// are made from the font's plain ones, so that all are there and alike; so are the blank as wide
/// as a digit, U+2007, and the thin one, U+2009.
Line typeset(const Font& font, std::string_view utf8);

/// The same or, where that is wider than `width` em, its beginning with an ellipsis; nothing where
/// not even that has room.
Line typeset_within(const Font& font, std::string_view utf8, double width);

/// The first character of the text that the font has not, nor typeset() makes.
std::optional<char32_t> missing_character(const Font& font, std::string_view utf8);

}  // namespace twrench
