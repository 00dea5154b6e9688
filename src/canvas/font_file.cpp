#include "canvas/font_file.h"

#include <cairo-ft.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H

#include <twrench/base/error.h>

#include <new>

namespace twrench::canvas::font_file {
namespace {

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

}  // namespace

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

bool has_outline(cairo_font_face_t* face, unsigned glyph) {
  const auto* opened =
      static_cast<OpenedFace*>(cairo_font_face_get_user_data(face, &opened_face_key));
  return FT_Load_Glyph(opened->face, glyph, FT_LOAD_NO_SCALE) == 0;
}

}  // namespace twrench::canvas::font_file
