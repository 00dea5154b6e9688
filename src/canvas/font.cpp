#include "canvas/font.h"

#include <cairo-ft.h>
#include <fmt/format.h>
#include <ft2build.h>
#include <hb.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/words.h"
#include "embedded/fonts.h"
#include "system/bytes.h"
#include "system/error.h"
#include "system/file.h"
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H
#include <twrench/base/error.h>

#include <new>

namespace twrench::canvas {
namespace {

using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// A FreeType face with the data that it reads. It has its own FreeType library, because two
/// threads must not open faces of one library at once.
struct OpenedFace {
  explicit OpenedFace(const Bytes& bytes) : file(bytes) {
    if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();
    error = FT_New_Memory_Face(library, file->data(), static_cast<FT_Long>(file->size()), 0, &face);
  }
  ~OpenedFace() { FT_Done_FreeType(library); }  // and its face
  OpenedFace(const OpenedFace&) = delete;
  OpenedFace& operator=(const OpenedFace&) = delete;

  Bytes file;
  FT_Library library = nullptr;
  FT_Face face = nullptr;  ///< null if there is an error
  FT_Error error = 0;
};

const cairo_user_data_key_t opened_face_key{};

/// FreeType omits tables that extend beyond the file; HarfBuzz lists them all.
bool has_all_its_tables(FT_Face face, hb_font_t* shaper) {
  FT_ULong readable = 0;
  FT_Sfnt_Table_Info(face, 0, nullptr, &readable);
  return readable == hb_face_get_table_tags(hb_font_get_face(shaper), 0, nullptr, nullptr);
}

/// Checks the file itself, because FreeType makes a map from the glyphs' names if there is none.
bool has_character_map(FT_Face face) {
  FT_ULong length = 0;
  return FT_Load_Sfnt_Table(face, FT_MAKE_TAG('c', 'm', 'a', 'p'), 0, nullptr, &length) == 0;
}

void require_usable(const OpenedFace& opened, hb_font_t* shaper, const std::string& what) {
  const FT_Face face = opened.face;
  if (face == nullptr || !has_all_its_tables(face, shaper)) {
    throw InvalidArgument(what, "is a damaged font: not all of its tables can be read");
  }
  if (!FT_IS_SCALABLE(face) || !has_character_map(face)) {
    throw InvalidArgument(what, "is a font without outlines or without a character map");
  }
}

/// Returns HarfBuzz's view of the file; the file must outlive it. Lengths are in units of the file.
/// Throws InvalidArgument about `what` unless the file is a TrueType or OpenType font or a
/// collection of these.
std::shared_ptr<hb_font_t> open_shaper(const Bytes& file, const std::string& what) {
  const std::unique_ptr<hb_blob_t, decltype(&hb_blob_destroy)> blob(
      hb_blob_create(reinterpret_cast<const char*>(file->data()),
                     static_cast<unsigned>(file->size()), HB_MEMORY_MODE_READONLY, nullptr,
                     nullptr),
      &hb_blob_destroy);
  if (hb_face_count(blob.get()) == 0) {
    throw InvalidArgument(what, "is not a TrueType or OpenType font");
  }
  const std::unique_ptr<hb_face_t, decltype(&hb_face_destroy)> face(hb_face_create(blob.get(), 0),
                                                                    &hb_face_destroy);
  std::shared_ptr<hb_font_t> font(hb_font_create(face.get()), &hb_font_destroy);
  hb_font_make_immutable(font.get());
  return font;
}

/// Returns FreeType's view of the same file, as a font face of Cairo. Throws InvalidArgument about
/// `what` if the font is damaged, has no outlines or has no map from characters to glyphs.
std::shared_ptr<cairo_font_face_t> open_face(const Bytes& file, hb_font_t* shaper,
                                             const std::string& what) {
  auto opened = std::make_unique<OpenedFace>(file);
  require_usable(*opened, shaper, what);
  std::shared_ptr<cairo_font_face_t> face(
      cairo_ft_font_face_create_for_ft_face(opened->face, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP),
      &cairo_font_face_destroy);
  // Cairo uses the face for glyphs in its cache even after the last Font with that face is
  // destroyed.
  const auto close = [](void* data) { delete static_cast<OpenedFace*>(data); };
  if (cairo_font_face_set_user_data(face.get(), &opened_face_key, opened.get(), close) !=
      CAIRO_STATUS_SUCCESS) {
    throw std::bad_alloc();
  }
  static_cast<void>(opened.release());
  return face;
}

/// Returns whether FreeType can read the glyph's outline from a face that open_face() returned.
bool has_outline(cairo_font_face_t* face, unsigned glyph) {
  const auto* opened =
      static_cast<OpenedFace*>(cairo_font_face_get_user_data(face, &opened_face_key));
  return FT_Load_Glyph(opened->face, glyph, FT_LOAD_NO_SCALE) == 0;
}

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
      shaper_(open_shaper(file_, what)),
      face_(open_face(file_, shaper(), what)) {
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

bool Font::can_draw(unsigned glyph) const { return has_outline(face(), glyph); }

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
