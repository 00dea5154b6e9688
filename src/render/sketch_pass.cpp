#include "render/sketch_pass.h"

#include <array>
#include <cstddef>

#include "embedded/shaders.h"

namespace twrench {
namespace {

/// Attribute locations of the members of Sketch::Vertex in the vertex shader.
enum SketchAttribute : GLuint { clip_attribute = 0, paint_attribute = 1, edge_attribute = 2 };

gl::Program sketch_program(const gl::Functions& gl) {
  const std::array vertex{gl::ShaderFile{"sketch.vert", embedded::shaders().at("sketch.vert")}};
  const std::array fragment{gl::ShaderFile{"sketch.frag", embedded::shaders().at("sketch.frag")}};
  return {gl, vertex, fragment};
}

void set_attribute(const gl::Functions& gl, SketchAttribute attribute, GLint size,
                   std::size_t offset) {
  gl.EnableVertexAttribArray(attribute);
  gl.VertexAttribPointer(
      attribute, size, GL_FLOAT, GL_FALSE, sizeof(Sketch::Vertex),
      // GL takes an offset for a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
      reinterpret_cast<const void*>(offset));
}

void upload(const gl::Functions& gl, GLenum target, std::span<const std::byte> bytes) {
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
}

}  // namespace

SketchPass::SketchPass(const gl::Functions& gl)
    : gl_(&gl), program_(sketch_program(gl)), array_(gl), vertices_(gl), indices_(gl) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  set_attribute(gl, clip_attribute, 4, offsetof(Sketch::Vertex, clip));
  set_attribute(gl, paint_attribute, 4, offsetof(Sketch::Vertex, paint));
  set_attribute(gl, edge_attribute, 3, offsetof(Sketch::Vertex, edge));
}

void SketchPass::draw(const Sketch& sketch, const std::vector<std::uint32_t>& indices,
                      GLboolean hides) const {
  if (indices.empty()) return;
  program_.use();
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  upload(*gl_, GL_ARRAY_BUFFER, std::as_bytes(std::span(sketch.vertices())));
  upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(std::span(indices)));
  gl_->Enable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DepthMask(hides);
  gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  gl_->DepthMask(GL_TRUE);
  gl_->Disable(GL_BLEND);
}

}  // namespace twrench
