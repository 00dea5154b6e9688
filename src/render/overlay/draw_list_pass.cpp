#include "render/overlay/draw_list_pass.h"

#include <array>
#include <cstddef>

#include "embedded/shaders.h"
#include "gl/vertices.h"

namespace twrench::render {
namespace {

/// Attribute locations of the members of DrawList::Vertex in the vertex shader.
enum DrawListAttribute : GLuint { clip_attribute = 0, paint_attribute = 1, edge_attribute = 2 };

gl::Program draw_list_program(const gl::Functions& gl) {
  const std::array vertex{
      gl::ShaderFile{"draw_list.vert", embedded::shaders().at("draw_list.vert")}};
  const std::array fragment{
      gl::ShaderFile{"draw_list.frag", embedded::shaders().at("draw_list.frag")}};
  return {gl, vertex, fragment};
}

}  // namespace

DrawListPass::DrawListPass(const gl::Functions& gl)
    : gl_(&gl), program_(draw_list_program(gl)), array_(gl), vertices_(gl), indices_(gl) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  gl::set_attributes(gl, sizeof(DrawList::Vertex),
                     {{clip_attribute, 4, offsetof(DrawList::Vertex, clip)},
                      {paint_attribute, 4, offsetof(DrawList::Vertex, paint)},
                      {edge_attribute, 3, offsetof(DrawList::Vertex, edge)}});
}

void DrawListPass::draw(const DrawList& list, const std::vector<std::uint32_t>& indices,
                        GLboolean hides) const {
  if (indices.empty()) return;
  program_.use();
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, list.vertices(), GL_STREAM_DRAW);
  gl::upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, indices, GL_STREAM_DRAW);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DepthMask(hides);
  gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  gl_->DepthMask(GL_TRUE);
  gl_->Disable(GL_BLEND);
}

}  // namespace twrench::render
