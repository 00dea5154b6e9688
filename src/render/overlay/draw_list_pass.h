#pragma once

#include "gl/handle.h"
#include "gl/program.h"
#include "render/overlay/draw_list.h"

namespace twrench::render {

/// Renders draw lists to the bound framebuffer as premultiplied colour.
class DrawListPass {
 public:
  explicit DrawListPass(const gl::Functions& gl);

  /// Draws opaque items with depth test and depth writes. Draw their edge quads when all of them
  /// are done.
  void draw_opaque(const DrawList& list) const { draw(list, list.indices(), GL_TRUE); }
  void draw_edge_quads(const DrawList& list) const {
    draw(list, list.edge_quad_indices(), GL_FALSE);
  }

  /// Draws translucent items, such as lines and glass: opaque items hide them, and they blend in
  /// order.
  void draw_translucent(const DrawList& list) const { draw(list, list.indices(), GL_FALSE); }

 private:
  void draw(const DrawList& list, const std::vector<std::uint32_t>& indices, GLboolean hides) const;

  const gl::Functions* gl_;
  gl::Program program_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
};

}  // namespace twrench::render
