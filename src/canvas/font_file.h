#pragma once

#include <cairo.h>
#include <hb.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// How the libraries that shape and draw text take a font's file: from memory, each by itself.
namespace twrench::canvas::font_file {

using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// HarfBuzz's view of the file, which outlives it; lengths are in units of the file. Throws
/// InvalidArgument about `what` unless the file is a TrueType or OpenType font or a collection of
/// such.
std::shared_ptr<hb_font_t> open_shaper(const Bytes& file, const std::string& what);

/// FreeType's view of the same file, handed to Cairo. Throws InvalidArgument about `what` for a
/// font that is damaged, that has no outlines or no map from characters.
std::shared_ptr<cairo_font_face_t> open_face(const Bytes& file, hb_font_t* shaper,
                                             const std::string& what);

/// Whether FreeType can read the glyph's outline from a face that open_face() made.
bool has_outline(cairo_font_face_t* face, unsigned glyph);

}  // namespace twrench::canvas::font_file
