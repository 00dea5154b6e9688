#pragma once

#include "gl/framebuffer.h"
#include "render/pending_layer.h"
#include "render/sketch_pass.h"

namespace twrench {

/// What a view without a body draws on: a part of the picture, in which `solid` things and then
/// `sheer` ones are seen by one camera.
class SketchPad {
 public:
  SketchPad(const gl::Functions& gl, const gl::Framebuffer& framebuffer, const Area& area)
      : framebuffer_(framebuffer), pass_(gl), area_(area) {}

  /// A blank page.
  void begin(const Camera& camera);

  /// The page as it is now, as large as what is on it.
  PendingLayer layer() const;

  /// Pixels: the width of a fine line in an area of this size.
  double hairline() const;

  Sketch solid, sheer;

 private:
  const gl::Framebuffer& framebuffer_;
  SketchPass pass_;
  Area area_;
};

}  // namespace twrench
