#include "canvas/canvas.h"

#include <bit>
#include <numbers>

namespace twrench::canvas {
namespace {

// Cairo stores a pixel as a native word with blue in its lowest byte. If that byte comes first in
// memory, colours whose red and blue are swapped are stored as RGBA.
static_assert(std::endian::native == std::endian::little);

}  // namespace

void Canvas::Destroy::operator()(cairo_t* context) const noexcept { cairo_destroy(context); }
void Canvas::Destroy::operator()(cairo_surface_t* surface) const noexcept {
  cairo_surface_destroy(surface);
}

Canvas::Canvas(image::Image& image, int x, int y)
    : surface_(cairo_image_surface_create_for_data(image.pixels.data(), CAIRO_FORMAT_ARGB32,
                                                   image.width, image.height,
                                                   static_cast<int>(image.row_bytes()))),
      context_(cairo_create(surface_.get())) {
  cairo_translate(context_.get(), -x, -y);
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::set(const Ink& ink) {
  cairo_set_source_rgba(context_.get(), ink.color.blue / 255.0, ink.color.green / 255.0,
                        ink.color.red / 255.0, ink.opacity);
}

// Draws glyphs as paths, because cairo_show_glyphs() moves them to whole pixels before Cairo 1.18
// and to quarters since. That spoils their spacing, and frames would depend on the version.
void Canvas::add_text(const Line& line, double size, const Point& at, Align align) {
  const double before = align == Align::left ? 0 : align == Align::right ? 1 : 0.5;
  const double start = at.x - before * line.width * size;
  const Font* font_set = nullptr;
  double scale_set = 0;
  for (const auto& [font, glyph, x, y, scale, character] : line.glyphs) {
    if (font != font_set) cairo_set_font_face(context_.get(), font->face());
    font_set = font;
    if (scale != scale_set) cairo_set_font_size(context_.get(), scale * size);
    scale_set = scale;
    const cairo_glyph_t placed{glyph, start + x * size, at.y + y * size};
    cairo_glyph_path(context_.get(), &placed, 1);
  }
}

void Canvas::text(const Line& line, double size, const Point& at, const Ink& ink, Align align) {
  add_text(line, size, at, align);
  set(ink);
  cairo_fill(context_.get());
}

void Canvas::text_halo(const Line& line, double size, const Point& at, double width, const Ink& ink,
                       Align align) {
  add_text(line, size, at, align);
  cairo_set_line_width(context_.get(), 2 * width);
  set(ink);
  cairo_save(context_.get());  // a halo is soft, and strokes are the main cost of text
  cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_FAST);
  cairo_set_tolerance(context_.get(), 0.3);
  cairo_stroke(context_.get());
  cairo_restore(context_.get());
}

void Canvas::polyline(std::span<const Point> points, double width, const Ink& ink) {
  for (const auto& [x, y] : points) cairo_line_to(context_.get(), x, y);
  cairo_set_line_width(context_.get(), width);
  set(ink);
  cairo_stroke(context_.get());
}

void Canvas::disc(const Point& centre, double radius, const Ink& ink) {
  cairo_arc(context_.get(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  set(ink);
  cairo_fill(context_.get());
}

void Canvas::rectangle(double x, double y, double width, double height, const Ink& ink) {
  cairo_rectangle(context_.get(), x, y, width, height);
  set(ink);
  cairo_fill(context_.get());
}

void Canvas::panel(const image::Area& area, double radius, const Ink& ink) {
  constexpr double quarter = std::numbers::pi / 2;
  const double left = area.x + radius, right = area.x + area.width - radius;
  const double top = area.y + radius, bottom = area.y + area.height - radius;
  cairo_arc(context_.get(), right, top, radius, -quarter, 0);
  cairo_arc(context_.get(), right, bottom, radius, 0, quarter);
  cairo_arc(context_.get(), left, bottom, radius, quarter, 2 * quarter);
  cairo_arc(context_.get(), left, top, radius, 2 * quarter, 3 * quarter);
  cairo_close_path(context_.get());
  set(ink);
  cairo_fill(context_.get());
}

}  // namespace twrench::canvas
