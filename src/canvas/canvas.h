#pragma once

#include <cairo.h>

#include <cstdint>
#include <memory>
#include <span>

#include "base/color.h"
#include "canvas/typesetting.h"
#include "image/area.h"
#include "image/image.h"

namespace twrench::canvas {

/// Draws on an image of RGBA, premultiplied, which outlives it. Lengths in px of the picture of
/// which the image is a part; whole numbers are the edges of pixels. All edges are anti-aliased.
class Canvas {
 public:
  struct Ink {
    Color color;
    double opacity = 1;
  };
  struct Point {
    double x, y;
  };
  enum class Align { left, centre, right };

  /// (x, y): where the image's top left corner lies in the picture.
  Canvas(image::Image& image, int x, int y);

  /// `size`: px per em; (x, y): where the baseline begins or, with another alignment, the point of
  /// it that is the middle or the end.
  void text(const Line& line, double size, const Point& at, const Ink& ink,
            Align align = Align::left);

  /// The outline of such a text, `width` px beyond its edges, to lay under it.
  void text_halo(const Line& line, double size, const Point& at, double width, const Ink& ink,
                 Align align = Align::left);

  /// Round ends and corners.
  void polyline(std::span<const Point> points, double width, const Ink& ink);
  void disc(const Point& centre, double radius, const Ink& ink);
  void rectangle(double x, double y, double width, double height, const Ink& ink);

  /// A rectangle whose corners are rounded with that radius, px.
  void panel(const image::Area& area, double radius, const Ink& ink);

 private:
  struct Destroy {
    void operator()(cairo_t* context) const noexcept;
    void operator()(cairo_surface_t* surface) const noexcept;
  };

  void set(const Ink& ink);
  void add_text(const Line& line, double size, const Point& at, Align align);

  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace twrench::canvas
