#include "canvas/font.h"

#include <fmt/format.h>
#include <hb.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/nearest.h"
#include "canvas/font_file.h"
#include "embedded/fonts.h"
#include "system/error.h"
#include "system/file.h"
#include "system/sha256.h"

namespace twrench::canvas {
namespace {

constexpr std::size_t largest_file = 64U << 20U;  // bytes; a complete Chinese font has 20 MB

constexpr std::u32string_view ten_digits = U"0123456789";

std::u32string characters_of_our_own_text() {
  std::u32string characters = U"\u00D7\u2212\u2026\u03C9";  // times, minus, ellipsis, omega
  for (char32_t character = U'!'; character <= U'~'; ++character) characters += character;
  return characters;
}

void require_outlines(const Font& font, const std::string& what) {
  for (const char32_t character : characters_of_our_own_text()) {
    const unsigned glyph = font.glyph(character);
    if (glyph != 0 && !font.can_draw(glyph)) {
      throw InvalidArgument(what,
                            fmt::format("is a damaged font: its character U+{:04X} cannot be read",
                                        static_cast<std::uint32_t>(character)));
    }
  }
}

Font embedded_font(const std::string& name) {
  const std::string_view file = embedded::fonts().at(name);
  return {{file.begin(), file.end()}, "font"};
}

Typeface embedded_typeface(const std::string& family) {
  return {embedded_font(family + "-Regular.ttf"), embedded_font(family + "-Medium.ttf")};
}

std::vector<std::uint8_t> read_font(const std::string& path) {
  try {
    return system::read_file(path, largest_file);
  } catch (const system::FileError& error) {
    throw InvalidArgument("font", error.what(), error.remedy());
  }
}

}  // namespace

Font::Font(std::vector<std::uint8_t> file, const std::string& what)
    : file_(std::make_shared<const std::vector<std::uint8_t>>(std::move(file))),
      shaper_(font_file::open_shaper(file_, what)),
      face_(font_file::open_face(file_, shaper(), what)) {
  require_outlines(*this, what);
  for (const char32_t digit : ten_digits) {
    digit_advance_ = std::max(digit_advance_, advance(glyph(digit)));
  }
  hb_glyph_extents_t extents{};
  hb_font_get_glyph_extents(shaper(), glyph(U'H'), &extents);
  cap_height_ = 1.0 * extents.y_bearing / units_per_em();
}

Font Font::with_fallback(const Font& fallback) const {
  Font both(*this);
  both.fallback_ = std::make_shared<const Font>(fallback);
  if (!has(U'H')) both.cap_height_ = fallback.cap_height_;
  if (&both.digits() != &both) both.digit_advance_ = fallback.digit_advance_;
  return both;
}

unsigned Font::glyph(char32_t character) const {
  hb_codepoint_t glyph = 0;
  return hb_font_get_nominal_glyph(shaper(), character, &glyph) != 0 ? glyph : 0;
}

bool Font::has(char32_t character) const {
  if (glyph(character) != 0) return true;
  hb_codepoint_t letter = 0, mark = 0;
  return hb_unicode_decompose(hb_unicode_funcs_get_default(), character, &letter, &mark) != 0 &&
         has(letter) && (mark == 0 || has(mark));
}

const Font& Font::digits() const {
  const auto own = [&](char32_t digit) { return glyph(digit) != 0; };
  return fallback_ && !std::ranges::all_of(ten_digits, own) ? *fallback_ : *this;
}

bool Font::can_draw(unsigned glyph) const { return font_file::has_outline(face(), glyph); }

double Font::advance(unsigned glyph) const {
  return 1.0 * hb_font_get_glyph_h_advance(shaper(), glyph) / units_per_em();
}

unsigned Font::units_per_em() const { return hb_face_get_upem(hb_font_get_face(shaper())); }

Typeface load_typeface(const std::string& name_or_path) {
  const std::vector<std::string> names{"sans", "mono"};
  const Typeface sans = embedded_typeface("Roboto");
  if (name_or_path == "sans") return sans;
  if (name_or_path == "mono") {
    const Typeface mono = embedded_typeface("FiraCode");
    return {mono.regular.with_fallback(sans.regular), mono.strong.with_fallback(sans.strong)};
  }
  const bool path = name_or_path.find_first_of("./") != std::string::npos;
  if (!path && !std::filesystem::exists(name_or_path)) {
    throw unknown_name("font", name_or_path, names);
  }
  const Font own(read_font(name_or_path), "font " + name_or_path);
  const Font font = own.with_fallback(sans.regular);  // one weight, like the file
  return {font, font};
}

std::string typeface_digest(const Typeface& typeface) {
  std::string all;
  for (const Font* font : {&typeface.regular, &typeface.strong}) {
    for (; font != nullptr; font = font->fallback()) all += system::sha256_hex(font->file());
  }
  return system::sha256_hex(
      std::span(reinterpret_cast<const std::uint8_t*>(all.data()), all.size()));
}

}  // namespace twrench::canvas
