struct hb_font_t;
#pragma once

#include <cairo.h>
#include <twrench/base/error.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace twrench::canvas {

/// A font: HarfBuzz shapes text with it, and Cairo draws its glyphs from FreeType's outlines.
/// Outlines are neither hinted nor replaced by bitmaps, so that they are the same on every machine.
/// Copies share their data.
class Font {
 public:
  /// Opens the bytes of a TrueType or OpenType file, or the first font of a collection. Throws
  /// InvalidArgument about `what` for other files and for damaged ones.
  Font(std::vector<std::uint8_t> file, const std::string& what);

  /// Returns the same font with `fallback` for the characters that it lacks.
  Font with_fallback(const Font& fallback) const;

  /// Returns the fallback; null if there is none.
  const Font* fallback() const { return fallback_.get(); }

  /// Returns the bytes of the font's file.
  std::span<const std::uint8_t> file() const { return *file_; }

  /// Returns the glyph of a single character; 0 if this font has none.
  unsigned glyph(char32_t character) const;

  /// Returns whether this font has a glyph for the character, or for all characters that compose
  /// it.
  bool has(char32_t character) const;

  /// Returns whether the glyph's outline can be read. Do not call it while another thread draws
  /// with the font.
  bool can_draw(unsigned glyph) const;

  /// Returns the glyph's advance in em.
  double advance(unsigned glyph) const;

  /// Returns the font for the digits of a line: this font if it has all ten, otherwise the
  /// fallback.
  const Font& digits() const;

  /// Returns the advance of the widest of the ten digits in em.
  double digit_advance() const { return digit_advance_; }

  /// Returns the height of an H in em; that of the fallback if this font has no H.
  double cap_height() const { return cap_height_; }

  /// Returns HarfBuzz's font, whose lengths are in units of the file: units_per_em() to an em.
  hb_font_t* shaper() const { return shaper_.get(); }
  unsigned units_per_em() const;

  /// Returns Cairo's font face.
  cairo_font_face_t* face() const { return face_.get(); }

 private:
  std::shared_ptr<const std::vector<std::uint8_t>> file_;
  std::shared_ptr<hb_font_t> shaper_;
  std::shared_ptr<cairo_font_face_t> face_;
  std::shared_ptr<const Font> fallback_;
  double digit_advance_ = 0;
  double cap_height_ = 0;
};

/// The regular and the bold font.
struct Typeface {
  Font regular;
  Font strong;
};

/// Loads "sans" or "mono", which are built in, or the file with that path, which is then used for
/// both fonts. The sans is the fallback of the others. Throws InvalidArgument about "font" for an
/// unknown name or a file that cannot be read, and as Font does.
Typeface load_typeface(const std::string& name_or_path);

/// Returns the SHA-256 of the bytes of the fonts and their fallbacks, which distinguishes files of
/// the same name.
std::string typeface_digest(const Typeface& typeface);

/// A text has a character that neither the font nor its fallback can draw.
class MissingGlyph : public InvalidArgument {
 public:
  MissingGlyph(const std::string& quantity, const std::string& why, char32_t character)
      : InvalidArgument(quantity, why), character_(character) {}

  char32_t character() const noexcept { return character_; }

 private:
  char32_t character_;
};

}  // namespace twrench::canvas
