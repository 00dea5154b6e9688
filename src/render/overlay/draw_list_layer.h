#pragma once

#include "gl/framebuffer.h"
#include "render/compose/pending_layer.h"
#include "render/overlay/draw_list_pass.h"

namespace twrench::render {

/// The canvas of a view without a body: a part of the picture in which opaque and then translucent
/// items are drawn for one camera.
class DrawListLayer {
 public:
  DrawListLayer(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                const image::Area& area)
      : framebuffer_(framebuffer), pass_(gl), area_(area) {}

  /// Clears the canvas.
  void begin(const Camera& camera);

  /// Returns the current contents as a layer that just contains them.
  PendingLayer layer() const;

  /// Returns the width in pixels of a thin line in an area of this size.
  double hairline() const;

  DrawList opaque, translucent;

 private:
  const gl::Framebuffer& framebuffer_;
  DrawListPass pass_;
  image::Area area_;
};

}  // namespace twrench::render
