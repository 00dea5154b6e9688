#pragma once

#include <Eigen/Core>
#include <vector>

#include "gl/framebuffer.h"
#include "image/area.h"

namespace twrench {

/// The part of a pane that holds what is drawn: convex shapes, each given by points, one pixel
/// wider for what GL may round otherwise.
class ScreenArea {
 public:
  /// In a picture `picture_height` pixels high.
  ScreenArea(const Area& pane, int picture_height) : pane_(pane), picture_height_(picture_height) {}

  /// The points added from now on are of another shape, which reaches `margin` pixels beyond them.
  void begin_shape(double margin = 0) { shapes_.push_back({{}, margin + 1}); }

  /// A point in clip space; one behind the eye, or that is no number, makes the area the whole
  /// pane.
  void add(const Eigen::Vector4f& clip);

  /// The least rectangle around all shapes, of at least one pixel.
  Area bounds() const;

  /// Rectangles that hold all shapes and do not overlap: what the shapes take of each band of
  /// `height` rows of the picture.
  std::vector<Area> bands(int height) const;

  /// As GL counts.
  gl::Rectangle rectangle(const Area& area) const {
    return {area.x, picture_height_ - area.y - area.height, area.width, area.height};
  }
  gl::Rectangle viewport() const { return rectangle(pane_); }

 private:
  using Pixel = Eigen::Array2d;  ///< of the picture, y down

  struct Shape {
    std::vector<Pixel> points;
    double margin;
  };

  Area pixels_between(const Pixel& low, const Pixel& high) const;

  Area pane_;
  int picture_height_;
  bool all_ = false;
  std::vector<Shape> shapes_;
};

}  // namespace twrench
