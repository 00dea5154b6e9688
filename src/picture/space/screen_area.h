#pragma once

#include <Eigen/Core>
#include <vector>

#include "image/area.h"

namespace twrench::picture {

/// The part of a pane that drawing covers: convex shapes, each given by points and grown by one
/// pixel because GL may round differently.
class ScreenArea {
 public:
  explicit ScreenArea(const image::Area& pane) : pane_(pane) {}

  /// Starts a new shape that extends `margin` pixels beyond its points.
  void begin_shape(double margin = 0) { shapes_.push_back({{}, margin + 1}); }

  /// Adds a point in clip space; a point behind the eye, or NaN, makes the area the entire pane.
  void add(const Eigen::Vector4f& clip);

  /// Returns the bounding rectangle of all shapes, at least one pixel in size.
  image::Area bounds() const;

  /// Returns disjoint rectangles that cover all shapes: the extent of the shapes in each band of
  /// `height` rows of the picture.
  std::vector<image::Area> bands(int height) const;

 private:
  using Pixel = Eigen::Array2d;  ///< In the picture, y down.

  struct Shape {
    std::vector<Pixel> points;
    double margin;
  };

  image::Area pixels_between(const Pixel& low, const Pixel& high) const;

  image::Area pane_;
  bool all_ = false;
  std::vector<Shape> shapes_;
};

}  // namespace twrench::picture
