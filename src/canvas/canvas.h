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

/// Draws on a premultiplied RGBA image, which must outlive the canvas. Lengths are in px of the
/// picture of which the image is a part; whole numbers are the edges of pixels. All edges are
/// anti-aliased.
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

  /// (x, y) is the position of the image's top left corner in the picture.
  Canvas(image::Image& image, int x, int y);

  /// Draws text of `size` px per em. `at` is the start of the baseline or, with another alignment,
  /// its middle or its end.
  void text(const Line& line, double size, const Point& at, const Ink& ink,
            Align align = Align::left);

  /// Draws the outline of such a text, up to `width` px beyond its edges, as a background for the
  /// text.
  void text_halo(const Line& line, double size, const Point& at, double width, const Ink& ink,
                 Align align = Align::left);

  /// Ends and corners are round.
  void polyline(std::span<const Point> points, double width, const Ink& ink);
  void disc(const Point& centre, double radius, const Ink& ink);
  void rectangle(double x, double y, double width, double height, const Ink& ink);

  /// Draws a rectangle whose corners are rounded with that radius in px.
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
