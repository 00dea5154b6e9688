#pragma once

#include <cairo.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct hb_font_t;

namespace twrench::canvas {

/// A font: HarfBuzz shapes text with it, and Cairo draws its glyphs from FreeType's outlines.
/// Outlines are neither hinted nor replaced by bitmaps, so that they are the same on every machine.
/// Copies share what they were made from.
class Font {
 public:
  /// From the bytes of a TrueType or OpenType file, or of a collection, of which it is the first.
  /// Throws InvalidArgument about `what` for anything else, and for a damaged file.
  Font(std::vector<std::uint8_t> file, const std::string& what);

  /// The same font, for whose missing characters `fallback` stands in.
  Font with_fallback(const Font& fallback) const;

  /// Null where no other font stands in.
  const Font* fallback() const { return fallback_.get(); }

  /// The bytes that it was made from.
  std::span<const std::uint8_t> file() const { return *file_; }

  /// The glyph that stands for a character by itself; 0 where this font has none.
  unsigned glyph(char32_t character) const;

  /// Whether this font has a glyph for the character, or for all of which it is composed.
  bool has(char32_t character) const;

  /// Whether the glyph's outline can be read. Not to be called while another thread draws with the
  /// font.
  bool can_draw(unsigned glyph) const;

  /// In em: by how much the pen moves on.
  double advance(unsigned glyph) const;

  /// From which the digits of a line are taken: this font where it has all ten, or the fallback.
  const Font& digits() const;

  /// In em: the advance of the widest of the ten digits.
  double digit_advance() const { return digit_advance_; }

  /// In em: the height of an H, of the fallback's where this font has none.
  double cap_height() const { return cap_height_; }

  /// HarfBuzz's font, whose lengths are in units of the file, of which an em has units_per_em().
  hb_font_t* shaper() const { return shaper_.get(); }
  unsigned units_per_em() const;

  /// Cairo's font face.
  cairo_font_face_t* face() const { return face_.get(); }

 private:
  std::shared_ptr<const std::vector<std::uint8_t>> file_;
  std::shared_ptr<hb_font_t> shaper_;
  std::shared_ptr<cairo_font_face_t> face_;
  std::shared_ptr<const Font> fallback_;
  double digit_advance_ = 0;
  double cap_height_ = 0;
};

/// For what is said, and for what is said loud.
struct Typeface {
  Font regular;
  Font strong;
};

/// "sans" and "mono", which are built in, or the file of that path, of which both fonts are then
/// made. The sans is the fallback of the others. Throws InvalidArgument about "font" for an unknown
/// name, a file that cannot be read, and as Font does.
Typeface load_typeface(const std::string& name_or_path);

/// The SHA-256 of the bytes of its fonts and their fallbacks: two files of one name are told apart
/// by it.
std::string typeface_digest(const Typeface& typeface);

}  // namespace twrench::canvas
