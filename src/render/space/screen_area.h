#pragma once

#include <Eigen/Core>
#include <vector>

#include "gl/framebuffer.h"
#include "image/area.h"

namespace twrench::render {

/// The part of a pane that is covered by drawing: convex shapes, each given by points, grown by one
/// pixel because GL may round differently.
class ScreenArea {
 public:
  /// For a picture `picture_height` pixels high.
  ScreenArea(const image::Area& pane, int picture_height)
      : pane_(pane), picture_height_(picture_height) {}

  /// Starts a new shape that extends `margin` pixels beyond its points.
  void begin_shape(double margin = 0) { shapes_.push_back({{}, margin + 1}); }

  /// Adds a point in clip space; a point behind the eye, or NaN, makes the area the entire pane.
  void add(const Eigen::Vector4f& clip);

  /// Returns the bounding rectangle of all shapes, at least one pixel in size.
  image::Area bounds() const;

  /// Returns disjoint rectangles that cover all shapes: the extent of the shapes in each band of
  /// `height` rows of the picture.
  std::vector<image::Area> bands(int height) const;

  /// Converts to GL's coordinates.
  gl::Rectangle rectangle(const image::Area& area) const {
    return {area.x, picture_height_ - area.y - area.height, area.width, area.height};
  }
  gl::Rectangle viewport() const { return rectangle(pane_); }

 private:
  using Pixel = Eigen::Array2d;  ///< In the picture, y down.

  struct Shape {
    std::vector<Pixel> points;
    double margin;
  };

  image::Area pixels_between(const Pixel& low, const Pixel& high) const;

  image::Area pane_;
  int picture_height_;
  bool all_ = false;
  std::vector<Shape> shapes_;
};

}  // namespace twrench::render
