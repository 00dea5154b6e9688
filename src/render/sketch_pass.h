#pragma once

#include "gl/handle.h"
#include "gl/program.h"
#include "render/sketch.h"

namespace twrench {

/// Renders draw lists to the bound framebuffer as premultiplied colour.
class SketchPass {
 public:
  explicit SketchPass(const gl::Functions& gl);

  /// Draws opaque items with depth test and depth writes. Draw their edge quads when all of them
  /// are done.
  void draw_solid(const Sketch& sketch) const { draw(sketch, sketch.indices(), GL_TRUE); }
  void draw_fins(const Sketch& sketch) const { draw(sketch, sketch.fin_indices(), GL_FALSE); }

  /// Draws translucent items, such as lines and glass: opaque items hide them, and they blend in
  /// order.
  void draw_sheer(const Sketch& sketch) const { draw(sketch, sketch.indices(), GL_FALSE); }

 private:
  void draw(const Sketch& sketch, const std::vector<std::uint32_t>& indices, GLboolean hides) const;

  const gl::Functions* gl_;
  gl::Program program_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
};

}  // namespace twrench
