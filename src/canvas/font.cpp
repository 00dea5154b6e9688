#include "canvas/font.h"

#include <fmt/format.h>
#include <stb/stb_truetype.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/nearest.h"
#include "base/sha256.h"
#include "embedded/fonts.h"

namespace twrench {
namespace {

constexpr std::size_t largest_file = 64U << 20U;  // bytes: a font of all Chinese is 20 MB

/// Big-endian numbers of a file, 0 beyond its end.
class Reader {
 public:
  explicit Reader(const std::vector<std::uint8_t>& file) : file_(file) {}

  std::size_t u16(std::size_t at) const { return u8(at) << 8U | u8(at + 1); }
  std::size_t u32(std::size_t at) const { return u16(at) << 16U | u16(at + 2); }
  bool holds(std::size_t offset, std::size_t length) const {
    return offset <= file_.size() && length <= file_.size() - offset;
  }

 private:
  std::size_t u8(std::size_t at) const { return at < file_.size() ? file_[at] : 0; }

  const std::vector<std::uint8_t>& file_;
};

/// Where the font begins in the file: the OpenType specification, "Organization of an OpenType
/// font". Throws unless all its tables lie in the file.
int checked_start(const std::vector<std::uint8_t>& file, const std::string& what) {
  const Reader read(file);
  const std::size_t collection = 0x74746366;  // "ttcf"
  const std::size_t start = read.u32(0) == collection ? read.u32(12) : 0;
  const std::size_t kind = read.u32(start);
  if (kind != 0x00010000 && kind != 0x4F54544F && kind != 0x74727565) {  // TrueType, OTTO, true
    throw UsageError(what, "is not a TrueType or OpenType font");
  }
  constexpr std::size_t header = 12, record = 16;
  const std::size_t count = read.u16(start + 4);
  bool whole = read.holds(start, header + count * record);
  for (std::size_t i = 0; whole && i < count; ++i) {
    const std::size_t at = start + header + i * record;
    whole = read.holds(read.u32(at + 8), read.u32(at + 12));
  }
  if (!whole) throw UsageError(what, "is a damaged font: it ends before its tables do");
  return static_cast<int>(start);
}

void require_characters(const Font& font, const std::string& what) {
  std::u32string needed = U"\u00D7\u2212\u2026\u03C9";  // times, minus, ellipsis, omega
  for (char32_t point = U'!'; point <= U'~'; ++point) needed += point;
  for (const char32_t point : needed) {
    if (font.glyph(point) != 0) continue;
    throw UsageError(what,
                     fmt::format("lacks the character U+{:04X}", static_cast<std::uint32_t>(point)),
                     "choose a font with the Latin alphabet, mathematical signs and Greek letters");
  }
}

std::vector<std::uint8_t> embedded_font(const std::string& name) {
  const std::string_view file = embedded::fonts().at(name);
  return {file.begin(), file.end()};
}

std::vector<std::uint8_t> font_file(const std::string& path) {
  try {
    return read_file(path, largest_file);
  } catch (const FileError& error) {
    throw UsageError("font", error.what(), error.remedy());
  }
}

}  // namespace

Font::Font(std::vector<std::uint8_t> file, const std::string& what)
    : file_(std::move(file)), info_(std::make_unique<stbtt_fontinfo>()) {
  const int start = checked_start(file_, what);
  if (stbtt_InitFont(info_.get(), file_.data(), start) == 0) {
    throw UsageError(what, "is a font without outlines or without a map from characters");
  }
  em_ = stbtt_ScaleForMappingEmToPixels(info_.get(), 1);
  require_characters(*this, what);
  for (char32_t digit = U'0'; digit <= U'9'; ++digit) {
    digit_advance_ = std::max(digit_advance_, advance(glyph(digit)));
  }
  int top = 0;
  stbtt_GetGlyphBox(info_.get(), glyph(U'H'), nullptr, nullptr, nullptr, &top);
  cap_height_ = em_ * top;
}

Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

int Font::glyph(char32_t point) const {
  return stbtt_FindGlyphIndex(info_.get(), static_cast<int>(point));
}

double Font::advance(int glyph) const {
  int advance = 0;
  stbtt_GetGlyphHMetrics(info_.get(), glyph, &advance, nullptr);
  return em_ * advance;
}

double Font::kerning(int left, int right) const {
  return em_ * stbtt_GetGlyphKernAdvance(info_.get(), left, right);
}

std::vector<Font::Segment> Font::outline(int glyph) const {
  stbtt_vertex* shape = nullptr;
  const int count = stbtt_GetGlyphShape(info_.get(), glyph, &shape);
  const auto free = [this](stbtt_vertex* memory) { stbtt_FreeShape(info_.get(), memory); };
  const std::unique_ptr<stbtt_vertex, decltype(free)> owner(shape, free);
  const auto at = [&](int x, int y) { return Point{em_ * x, -em_ * y}; };
  // A parabola with the control point c is the cubic with controls two thirds of the way to c.
  const auto toward = [](const Point& from, const Point& to) {
    return Point{from.x + 2.0 / 3 * (to.x - from.x), from.y + 2.0 / 3 * (to.y - from.y)};
  };
  std::vector<Segment> outline;
  Point pen{};
  for (int i = 0; i < count; ++i) {
    const stbtt_vertex& v = shape[i];
    const Point end = at(v.x, v.y);
    const Point control = at(v.cx, v.cy);
    switch (v.type) {
      case STBTT_vmove:
        outline.push_back({Segment::start, {}, {}, end});
        break;
      case STBTT_vline:
        outline.push_back({Segment::line, {}, {}, end});
        break;
      case STBTT_vcurve:
        outline.push_back({Segment::curve, toward(pen, control), toward(end, control), end});
        break;
      default:
        outline.push_back({Segment::curve, control, at(v.cx1, v.cy1), end});
    }
    pen = end;
  }
  return outline;
}

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
  const std::vector<std::uint8_t> file = font_file(name_or_path);
  const std::string what = "font " + name_or_path;
  return {Font(file, what), Font(file, what)};
}

std::string typeface_digest(const Typeface& typeface) {
  const std::string both = sha256_hex(typeface.regular.file()) + sha256_hex(typeface.strong.file());
  return sha256_hex(std::span(reinterpret_cast<const std::uint8_t*>(both.data()), both.size()));
}

}  // namespace twrench
