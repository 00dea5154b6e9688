#include "canvas/font.h"

#include <fmt/format.h>
#include <hb.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/nearest.h"
#include "base/sha256.h"
#include "canvas/font_file.h"
#include "embedded/fonts.h"

namespace twrench {
namespace {

constexpr std::size_t largest_file = 64U << 20U;  // bytes: a font of all Chinese is 20 MB

std::u32string characters_of_our_own_text() {
  std::u32string characters = U"\u00D7\u2212\u2026\u03C9";  // times, minus, ellipsis, omega
  for (char32_t character = U'!'; character <= U'~'; ++character) characters += character;
  return characters;
}

void require_characters(const Font& font, const std::string& what) {
  for (const char32_t character : characters_of_our_own_text()) {
    const unsigned glyph = font.glyph(character);
    const auto code = static_cast<std::uint32_t>(character);
    if (glyph == 0) {
      throw InvalidArgument(
          what, fmt::format("lacks the character U+{:04X}", code),
          "choose a font with the Latin alphabet, mathematical signs and Greek letters");
    }
    if (!font.can_draw(glyph)) {
      throw InvalidArgument(
          what, fmt::format("is a damaged font: its character U+{:04X} cannot be read", code));
    }
  }
}

std::vector<std::uint8_t> embedded_font(const std::string& name) {
  const std::string_view file = embedded::fonts().at(name);
  return {file.begin(), file.end()};
}

std::vector<std::uint8_t> read_font(const std::string& path) {
  try {
    return read_file(path, largest_file);
  } catch (const FileError& error) {
    throw InvalidArgument("font", error.what(), error.remedy());
  }
}

}  // namespace

Font::Font(std::vector<std::uint8_t> file, const std::string& what)
    : file_(std::make_shared<const std::vector<std::uint8_t>>(std::move(file))),
      shaper_(font_file::open_shaper(file_, what)),
      face_(font_file::open_face(file_, shaper(), what)) {
  require_characters(*this, what);
  for (char32_t digit = U'0'; digit <= U'9'; ++digit) {
    digit_advance_ = std::max(digit_advance_, advance(glyph(digit)));
  }
  hb_glyph_extents_t extents{};
  hb_font_get_glyph_extents(shaper(), glyph(U'H'), &extents);
  cap_height_ = 1.0 * extents.y_bearing / units_per_em();
}

unsigned Font::glyph(char32_t character) const {
  hb_codepoint_t glyph = 0;
  return hb_font_get_nominal_glyph(shaper(), character, &glyph) != 0 ? glyph : 0;
}

bool Font::can_draw(unsigned glyph) const { return font_file::has_outline(face(), glyph); }

double Font::advance(unsigned glyph) const {
  return 1.0 * hb_font_get_glyph_h_advance(shaper(), glyph) / units_per_em();
}

unsigned Font::units_per_em() const { return hb_face_get_upem(hb_font_get_face(shaper())); }

Typeface load_typeface(const std::string& name_or_path) {
  const std::vector<std::string> names{"sans", "mono"};
  const std::map<std::string, std::string> families{{"sans", "Roboto"}, {"mono", "FiraCode"}};
  if (const auto family = families.find(name_or_path); family != families.end()) {
    return {Font(embedded_font(family->second + "-Regular.ttf"), "font"),
            Font(embedded_font(family->second + "-Medium.ttf"), "font")};
  }
  const bool path = name_or_path.find_first_of("./") != std::string::npos;
  if (!path && !std::filesystem::exists(name_or_path)) {
    throw unknown_name("font", name_or_path, names);
  }
  const Font font(read_font(name_or_path), "font " + name_or_path);
  return {font, font};
}

std::string typeface_digest(const Typeface& typeface) {
  const std::string both = sha256_hex(typeface.regular.file()) + sha256_hex(typeface.strong.file());
  return sha256_hex(std::span(reinterpret_cast<const std::uint8_t*>(both.data()), both.size()));
}

}  // namespace twrench
