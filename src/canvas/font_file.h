#pragma once

#include <cairo.h>
#include <hb.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// Opens font files from memory, separately for the libraries that shape and draw text.
namespace twrench::canvas::font_file {

using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Returns HarfBuzz's view of the file; the file must outlive it. Lengths are in units of the file.
/// Throws InvalidArgument about `what` unless the file is a TrueType or OpenType font or a
/// collection of these.
std::shared_ptr<hb_font_t> open_shaper(const Bytes& file, const std::string& what);

/// Returns FreeType's view of the same file, as a font face of Cairo. Throws InvalidArgument about
/// `what` if the font is damaged, has no outlines or has no map from characters to glyphs.
std::shared_ptr<cairo_font_face_t> open_face(const Bytes& file, hb_font_t* shaper,
                                             const std::string& what);

/// Returns whether FreeType can read the glyph's outline from a face that open_face() returned.
bool has_outline(cairo_font_face_t* face, unsigned glyph);

}  // namespace twrench::canvas::font_file
