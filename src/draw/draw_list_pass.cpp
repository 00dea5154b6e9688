#include "draw/draw_list_pass.h"

#include <array>
#include <cstddef>

#include "draw/view_painter.h"
#include "embedded/shaders.h"
#include "gl/program.h"
#include "picture/space/screen_area.h"

namespace twrench::draw {
namespace {

using picture::DrawList;

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

void DrawListPass::draw_ghosts(const DrawList& list) const {
  constexpr double faintest = 0.25;
  draw(list, list.ghosts().faces, {.faces = Faces::near, .hidden = true, .opacity = faintest});
  draw(list, list.ghosts().edge_quads, {.hidden = true, .opacity = faintest});
  // Each step is moved towards the eye by less than the one before. The visible steps add up, so
  // the opacity increases gradually towards the front.
  constexpr int steps = 5;
  constexpr double deepest = 0.01;  // as a share of the pane's height
  const auto shown = [](int step) { return faintest + (1 - faintest) * step / (steps + 1); };
  std::array<Mode, steps> fade;
  for (int step = 1; step <= steps; ++step) {
    const double nearer = deepest * (steps + 1 - step) / steps;
    fade[static_cast<std::size_t>(step - 1)] = {
        .faces = Faces::near,
        .opacity = (shown(step) - shown(step - 1)) / (1 - shown(step - 1)),
        .clip_z = list.clip_z_nearer(nearer)};
  }
  draw_each(list, list.ghosts().faces, fade);
}

void DrawListPass::draw_opaque(const DrawList& list) const {
  draw(list, list.items().faces, {.writes_depth = true});
  draw(list, list.outlines().faces, {.faces = Faces::far});
}

void DrawListPass::draw_edge_quads(const DrawList& list) const {
  draw(list, list.outlines().edge_quads, {});
  draw(list, list.items().edge_quads, {});
}

void DrawListPass::draw_each(const DrawList& list, const std::vector<std::uint32_t>& indices,
                             std::span<const Mode> modes) const {
  if (indices.empty()) return;
  program_.use();
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, list.vertices(), GL_STREAM_DRAW);
  gl::upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, indices, GL_STREAM_DRAW);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const Mode& mode : modes) {
    program_.set("opacity", static_cast<float>(mode.opacity));
    program_.set("clip_z", static_cast<float>(mode.clip_z));
    gl_->DepthFunc(mode.hidden ? GL_GREATER : GL_LESS);
    gl_->DepthMask(mode.writes_depth ? GL_TRUE : GL_FALSE);
    mode.faces == Faces::all ? gl_->Disable(GL_CULL_FACE) : gl_->Enable(GL_CULL_FACE);
    gl_->FrontFace(mode.faces == Faces::far ? GL_CW : GL_CCW);
    gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  }
  gl_->DepthFunc(GL_LESS);
  gl_->DepthMask(GL_TRUE);
  gl_->FrontFace(GL_CCW);
  gl_->Disable(GL_CULL_FACE);
  gl_->Disable(GL_BLEND);
}

std::vector<picture::Layer> DrawListPainter::draw_still(const picture::ViewContents& contents) {
  std::vector<picture::Layer> layers;
  for (PendingLayer& layer : draw(contents)) {
    layer.fetch();
    layers.push_back(std::get<picture::Layer>(layer.finish()));
  }
  return layers;
}

std::vector<PendingLayer> DrawListPainter::draw(const picture::ViewContents& contents) {
  if (contents.is_empty()) return {};
  picture::ScreenArea screen(pane_);
  contents.opaque.add_to(screen);
  contents.translucent.add_to(screen);
  const image::Area area = screen.bounds();
  const gl::Rectangle rectangle = gl_rectangle(area, framebuffer_.height());
  framebuffer_.clear({&rectangle, 1});
  framebuffer_.draw_within(rectangle, gl_rectangle(pane_, framebuffer_.height()));
  pass_.draw_opaque(contents.opaque);
  pass_.draw_edge_quads(contents.opaque);
  pass_.draw_translucent(contents.translucent);
  std::vector<PendingLayer> layers;
  layers.push_back(layer_at(area, framebuffer_.begin_read(rectangle)));
  return layers;
}

}  // namespace twrench::draw
