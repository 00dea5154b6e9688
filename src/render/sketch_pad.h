#pragma once

#include "gl/framebuffer.h"
#include "render/pending_layer.h"
#include "render/sketch_pass.h"

namespace twrench {

/// The canvas of a view without a body: a part of the picture in which opaque and then translucent
/// items are drawn for one camera.
class SketchPad {
 public:
  SketchPad(const gl::Functions& gl, const gl::Framebuffer& framebuffer, const Area& area)
      : framebuffer_(framebuffer), pass_(gl), area_(area) {}

  /// Clears the canvas.
  void begin(const Camera& camera);

  /// Returns the current contents as a layer that just contains them.
  PendingLayer layer() const;

  /// Returns the width in pixels of a thin line in an area of this size.
  double hairline() const;

  Sketch solid, sheer;

 private:
  const gl::Framebuffer& framebuffer_;
  SketchPass pass_;
  Area area_;
};

}  // namespace twrench
