#pragma once

#include <Eigen/Core>

#include "gl/framebuffer.h"
#include "image/area.h"

namespace twrench {

/// The least rectangle of a pane that holds what is drawn at the points it has seen, one pixel
/// wider for what GL may round otherwise.
class ScreenArea {
 public:
  /// In a picture `picture_height` pixels high.
  ScreenArea(const Area& pane, int picture_height) : pane_(pane), picture_height_(picture_height) {}

  /// A point in clip space; one behind the eye makes the area the whole pane. `margin` in pixels:
  /// how far what is drawn there reaches beyond.
  void add(const Eigen::Vector4f& clip, float margin = 0);

  /// The area seen so far, of at least one pixel, as images count and as GL does.
  Area area() const;
  gl::Rectangle rectangle() const { return rectangle_of(area(), picture_height_); }
  gl::Rectangle viewport() const { return rectangle_of(pane_, picture_height_); }

 private:
  static gl::Rectangle rectangle_of(const Area& area, int picture_height) {
    return {area.x, picture_height - area.y - area.height, area.width, area.height};
  }

  Area pane_;
  int picture_height_;
  bool all_ = false;
  Eigen::Array2f low_{1e9F, 1e9F}, high_{-1e9F, -1e9F};  ///< pixels of the pane, y down
};

}  // namespace twrench
