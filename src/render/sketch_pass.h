#pragma once

#include "gl/handle.h"
#include "gl/program.h"
#include "render/sketch.h"

namespace twrench {

/// Draws sketches on the framebuffer that is bound, as premultiplied colour.
class SketchPass {
 public:
  explicit SketchPass(const gl::Functions& gl);

  /// Solid things hide and are hidden; their fins are to be drawn when all of them are.
  void draw_solid(const Sketch& sketch) const { draw(sketch, sketch.indices(), GL_TRUE); }
  void draw_fins(const Sketch& sketch) const { draw(sketch, sketch.fin_indices(), GL_FALSE); }

  /// Sheer things, lines and glass, are hidden by solid ones only, and lie over those before.
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
