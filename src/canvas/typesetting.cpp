#include "canvas/typesetting.h"

#include <fmt/format.h>
#include <hb.h>

#include <algorithm>
#include <memory>
#include <new>
#include <optional>

#include "canvas/font.h"
#include "canvas/text_runs.h"

namespace twrench::canvas {
namespace {

using Buffer = std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)>;

/// The scale of a style, and its distance below the baseline in em.
struct Setting {
  double scale, y;
};

Setting setting_of(CharacterStyle style) {
  constexpr double small = 0.66;
  if (style == CharacterStyle::raised) return {small, -0.34};
  if (style == CharacterStyle::lowered) return {small, 0.16};
  return {1, 0};
}

void shape(hb_buffer_t* buffer, const StyledText& text, const TextRun& run) {
  hb_buffer_clear_contents(buffer);
  hb_buffer_add_codepoints(buffer, text.characters.data(), static_cast<int>(text.characters.size()),
                           static_cast<unsigned>(run.begin), static_cast<int>(run.end - run.begin));
  hb_buffer_set_direction(buffer, run.direction);
  hb_buffer_set_script(buffer, run.script);
  hb_shape(run.font->shaper(), buffer, nullptr, 0);
  if (!hb_buffer_allocation_successful(buffer)) throw std::bad_alloc();
}

/// Returns the width in em of a character that has a fixed one in a text of this font.
std::optional<double> fixed_room(const Font& font, hb_codepoint_t character) {
  const bool is_digit = character >= U'0' && character <= U'9';
  if (is_digit || character == U'\u2007') return font.digit_advance();
  if (character == U'\u2009') return 0.2;  // as wide as a letter in some fonts
  return std::nullopt;
}

/// Appends the shaped glyphs in the buffer at the right end of the line, which is set in this font.
void append(Line& line, const Font& font, hb_buffer_t* buffer, const StyledText& text,
            const TextRun& run) {
  const auto [scale, y] = setting_of(run.style);
  const double em = scale / run.font->units_per_em();
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer, nullptr);
  for (unsigned i = 0; i < count; ++i) {
    const hb_glyph_position_t& position = positions[i];
    const std::size_t character = infos[i].cluster;
    double room = em * position.x_advance, before = 0;
    const auto fixed = fixed_room(font, text.characters[character]);
    if (fixed && position.x_advance != 0) {  // marks have no advance
      room = scale * *fixed;
      before = (room - scale * run.font->advance(infos[i].codepoint)) / 2;
    }
    line.glyphs.push_back({run.font, infos[i].codepoint,
                           line.width + before + em * position.x_offset, y - em * position.y_offset,
                           scale, character});
    line.width += room;
  }
}

Line typeset(const Font& font, const StyledText& text) {
  Line line{{}, 0};
  const Buffer buffer(hb_buffer_create(), &hb_buffer_destroy);
  for (const TextRun& run : visual_runs(text, font)) {
    shape(buffer.get(), text, run);
    append(line, font, buffer.get(), text, run);
  }
  return line;
}

/// The places where the text may be cut: before the first character of each glyph.
std::vector<std::size_t> places_to_cut(const Line& line) {
  std::vector<std::size_t> places;
  for (const Line::Placed& glyph : line.glyphs) places.push_back(glyph.character);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

Line typeset(const Font& font, std::string_view utf8) { return typeset(font, styled(utf8)); }

Line typeset_within(const Font& font, std::string_view utf8, double width) {
  const StyledText text = styled(utf8);
  Line line = typeset(font, text);
  if (line.width <= width || line.glyphs.empty()) return line;
  const std::vector<std::size_t> places = places_to_cut(line);
  const auto cut_at = [&](std::size_t place) {
    std::size_t kept = places[place];
    while (kept > 0 && text.characters[kept - 1] == U' ') --kept;
    return typeset(font, shortened(text, kept));
  };
  // Finds the longest beginning that fits by bisection, because a title may have a million
  // characters.
  std::size_t fit = 0, most = places.size() - 1;
  while (fit < most) {
    const std::size_t place = most - (most - fit) / 2;
    if (cut_at(place).width <= width) {
      fit = place;
    } else {
      most = place - 1;
    }
  }
  line = cut_at(fit);
  return line.width <= width ? line : Line{{}, 0};
}

std::optional<char32_t> missing_character(const Font& font, std::string_view utf8) {
  const StyledText text = styled(utf8);
  std::optional<std::size_t> first;
  for (const Line::Placed& placed : typeset(font, text).glyphs) {
    if (placed.glyph != 0 && placed.font->can_draw(placed.glyph)) continue;
    first = std::min(first.value_or(placed.character), placed.character);
  }
  if (!first) return std::nullopt;
  // A letter and its marks form one glyph there, so that the missing character may be a mark.
  const auto lacks = [&](hb_codepoint_t character) {
    return !font.has(character) && (font.fallback() == nullptr || !font.fallback()->has(character));
  };
  const auto begin = text.characters.begin() + static_cast<std::ptrdiff_t>(*first);
  const auto missing = std::find_if(begin, text.characters.end(), lacks);
  return static_cast<char32_t>(missing == text.characters.end() ? *begin : *missing);
}

void require_characters(const Font& font, std::string_view utf8, const std::string& what) {
  const auto missing = missing_character(font, utf8);
  if (!missing) return;
  throw MissingGlyph(what,
                     fmt::format("contains the character U+{:04X}, which neither the font nor the "
                                 "built-in sans can draw",
                                 static_cast<std::uint32_t>(*missing)),
                     *missing);
}

}  // namespace twrench::canvas
