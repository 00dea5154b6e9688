#include "canvas/typesetting.h"

#include <optional>
#include <span>

#include "canvas/utf8.h"

namespace twrench {
namespace {

struct Character {
  char32_t point;
  double y = 0;  ///< em below the baseline
  double scale = 1;
};

/// What a raised or lowered character is made of.
Character plain(char32_t point) {
  constexpr double scale = 0.66, raised = -0.34, lowered = 0.16;
  constexpr std::u32string_view superscripts = U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", subscripts = U"₀₁₂₃₄₅₆₇₈₉₊₋";
  constexpr std::u32string_view plains = U"0123456789+−";
  if (const auto i = superscripts.find(point); i != std::u32string_view::npos) {
    return {plains[i], raised, scale};
  }
  if (const auto i = subscripts.find(point); i != std::u32string_view::npos) {
    return {plains[i], lowered, scale};
  }
  return {point};
}

/// Blanks that need no glyph: as wide as a digit, and what parts thousands.
std::optional<double> blank(const Font& font, char32_t point) {
  if (point == U'\u2007') return font.digit_advance();
  if (point == U'\u2009') return 0.2;
  return std::nullopt;
}

bool is_digit(char32_t point) { return point >= U'0' && point <= U'9'; }

Line typeset(const Font& font, std::span<const char32_t> points) {
  Line line{&font, {}, 0};
  Character before{U'\0'};
  for (const char32_t point : points) {
    const Character now = plain(point);
    if (const auto width = blank(font, point)) {
      line.width += *width;
      before = {U'\0'};
      continue;
    }
    const int glyph = font.glyph(now.point);
    const bool kerned = before.point != U'\0' && now.scale == before.scale &&
                        !(is_digit(now.point) && is_digit(before.point));
    if (kerned) line.width += now.scale * font.kerning(line.glyphs.back().glyph, glyph);
    const double advance = font.advance(glyph);
    const double room = is_digit(now.point) ? font.digit_advance() : advance;
    line.glyphs.push_back({glyph, line.width + now.scale * (room - advance) / 2, now.y, now.scale});
    line.width += now.scale * room;
    before = now;
  }
  return line;
}

}  // namespace

Line typeset(const Font& font, std::string_view utf8) { return typeset(font, decode_utf8(utf8)); }

Line typeset_within(const Font& font, std::string_view utf8, double width) {
  const std::vector<char32_t> points = decode_utf8(utf8);
  Line line = typeset(font, points);
  if (line.width <= width || points.empty()) return line;
  const auto shortened = [&](std::size_t kept) {
    while (kept > 0 && points[kept - 1] == U' ') --kept;
    std::vector<char32_t> some(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(kept));
    some.push_back(U'…');
    return typeset(font, some);
  };
  // The most characters that fit. Halved, for a title may have a million.
  std::size_t fit = 0, most = points.size() - 1;
  while (fit < most) {
    const std::size_t kept = most - (most - fit) / 2;
    if (shortened(kept).width <= width) {
      fit = kept;
    } else {
      most = kept - 1;
    }
  }
  line = shortened(fit);
  return line.width <= width ? line : Line{&font, {}, 0};
}

std::optional<char32_t> missing_character(const Font& font, std::string_view utf8) {
  for (const char32_t point : decode_utf8(utf8)) {
    if (!blank(font, point) && font.glyph(plain(point).point) == 0) return point;
  }
  return std::nullopt;
}

}  // namespace twrench
