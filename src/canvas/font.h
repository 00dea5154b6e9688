#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct stbtt_fontinfo;

namespace twrench {

/// A typeface: outlines and measures of its glyphs, read by stb_truetype. All lengths are in em, y
/// down, x from the pen, which moves on by the glyph's advance.
class Font {
 public:
  struct Point {
    double x, y;
  };
  /// A piece of an outline, which is closed: from where the last one ended, by a cubic where
  /// `curve`, or, where `start`, a new contour's first point.
  struct Segment {
    enum Kind { start, line, curve } kind;
    Point control1, control2;  ///< of a curve
    Point end;
  };

  /// From the bytes of a TrueType or OpenType file, or of a collection, of which it is the first.
  /// Throws UsageError about `what` for anything else, for a damaged file, and for a font that
  /// lacks a character of this program's own words.
  ///
  /// Tables that lie beyond the file's end are refused; within its tables the file is trusted, as
  /// stb_truetype does: a font made to do harm can do harm.
  Font(std::vector<std::uint8_t> file, const std::string& what);
  ~Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;

  /// The bytes that it was made from.
  std::span<const std::uint8_t> file() const { return file_; }

  /// 0 where it has none.
  int glyph(char32_t point) const;

  double advance(int glyph) const;
  double kerning(int left, int right) const;  ///< to add to the advance between them
  std::vector<Segment> outline(int glyph) const;

  /// The advance of the widest of the ten digits.
  double digit_advance() const { return digit_advance_; }
  /// The height of an H.
  double cap_height() const { return cap_height_; }

 private:
  std::vector<std::uint8_t> file_;
  std::unique_ptr<stbtt_fontinfo> info_;
  double em_ = 0;  ///< per unit of the file
  double digit_advance_ = 0;
  double cap_height_ = 0;
};

/// For what is said, and for what is said loud.
struct Typeface {
  Font regular;
  Font strong;
};

/// "sans" and "mono", which are built in, or the file of that path, of which both fonts are then
/// made. Throws UsageError about "font" for an unknown name, a file that cannot be read, and as
/// Font does.
Typeface load_typeface(const std::string& name_or_path);

/// The SHA-256 of the bytes of both its fonts: two files of one name are told apart by it.
std::string typeface_digest(const Typeface& typeface);

}  // namespace twrench
