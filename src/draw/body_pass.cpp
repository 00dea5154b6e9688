#include "draw/body_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "embedded/shaders.h"
#include "gl/program.h"
#include "picture/body/facets.h"
#include "picture/body/shader_constants.h"
#include "picture/space/glm_from_eigen.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using picture::BodyModel;
using picture::Camera;
using picture::EdgeQuadVertex;
using picture::Material;
using picture::PartModel;
using picture::Shift;
using picture::Vertex;

std::vector<std::size_t> side_begins(const BodyModel& body) {
  std::vector<std::size_t> begins;
  for (const PartModel& part : body.parts) begins.push_back(part.side_begin);
  return begins;
}

/// The properties that select a program, in addition to the studio.
struct ProgramKind {
  Material material;
  bool is_colored;  ///< Whether vertices have colours.

  bool operator==(const ProgramKind&) const = default;
};

/// The file with the diffuse term.
const char* scattering_of(const Material& material) {
  if (material.is_rock) return "regolith.glsl";
  return material.diffuse == glm::vec3(0) ? "metal.glsl" : "matte.glsl";
}

/// Whether the body has a diffuse term is decided at compile time instead of at each pixel:
/// llvmpipe executes both branches of an if, and the second doubles the work.
gl::Program body_program(const gl::Functions& gl, const ProgramKind& kind, const BodyModel& body,
                         bool is_of_one_material) {
  const auto file = [](const char* name) {
    return gl::ShaderFile{name, embedded::shaders().at(name)};
  };
  const std::string constants =
      picture::shader_constants(kind.material, body.studio) +
      fmt::format("const int occluder_count = {};\nconst bool is_of_one_material = {};\n",
                  body.occluder_count, is_of_one_material);
  const bool alone = body.occluder_count == 0;
  const std::array vertex{gl::ShaderFile{"constants", constants},
                          file(alone ? "unoccluded.vert" : "occluders.vert"),
                          file(kind.is_colored ? "colored.vert" : "plain.vert"),
                          file(body.mark ? "marked.vert" : "unmarked.vert"), file("body.vert")};
  const std::array fragment{gl::ShaderFile{"constants", constants},
                            file("studio.glsl"),
                            file(kind.is_colored ? "colored.glsl" : "plain.glsl"),
                            file(alone ? "unoccluded.glsl" : "occluders.glsl"),
                            file("tone.glsl"),
                            file("brush.glsl"),
                            file(body.mark ? "marked.glsl" : "unmarked.glsl"),
                            file(scattering_of(kind.material)),
                            file("body.frag")};
  return {gl, vertex, fragment};
}

/// The shader's `picture` uniform without displacement.
constexpr glm::vec3 as_drawn(1, 1, 0);

}  // namespace

BodyPass::BodyPass(const gl::Functions& gl, const BodyModel& body)
    : gl_(&gl),
      body_(&body),
      side_begins_(side_begins(body)),
      array_(gl),
      edge_quad_array_(gl),
      vertices_(gl),
      colors_(gl),
      indices_(gl),
      visible_indices_(gl),
      shifts_(gl),
      edge_quads_(gl),
      edge_quad_indices_(gl) {
  add_programs();
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  gl::upload(gl, GL_ELEMENT_ARRAY_BUFFER, body.mesh.indices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl::upload(gl, GL_ARRAY_BUFFER, body.mesh.vertices, GL_STATIC_DRAW);
  gl::set_attributes(gl, sizeof(Vertex),
                     {{position_attribute, 3, offsetof(Vertex, position)},
                      {normal_attribute, 3, offsetof(Vertex, normal)}});
  gl.BindBuffer(GL_ARRAY_BUFFER, shifts_.id());
  gl::upload(gl, GL_ARRAY_BUFFER, std::vector<Shift>(body.mesh.vertices.size()), GL_STREAM_DRAW);
  gl::set_attributes(gl, sizeof(Shift), {{shift_attribute, 4}});

  gl.BindVertexArray(edge_quad_array_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, edge_quad_indices_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, edge_quads_.id());
  gl::set_attributes(gl, sizeof(EdgeQuadVertex),
                     {{position_attribute, 3, offsetof(EdgeQuadVertex, position)},
                      {normal_attribute, 3, offsetof(EdgeQuadVertex, normal)},
                      {shift_attribute, 4, offsetof(EdgeQuadVertex, shift)},
                      {fade_attribute, 2, offsetof(EdgeQuadVertex, transparency)}});
  if (!body.mesh.colors.empty()) add_colors();
}

void BodyPass::add_programs() {
  std::vector<ProgramKind> kinds;
  for (std::size_t i = 0; i < body_->parts.size(); ++i) {
    const ProgramKind kind{body_->materials[i], body_->mesh.is_colored[i] != 0};
    const auto found = std::ranges::find(kinds, kind);
    program_of_part_.push_back(static_cast<std::size_t>(found - kinds.begin()));
    if (found == kinds.end()) kinds.push_back(kind);
  }
  is_of_one_material_ = kinds.size() == 1 && !kinds.front().is_colored;
  for (const ProgramKind& kind : kinds) {
    programs_.push_back(body_program(*gl_, kind, *body_, is_of_one_material_));
  }
}

/// Makes both vertex arrays read colours. The array of the edge quads must be bound.
void BodyPass::add_colors() {
  gl::set_attributes(*gl_, sizeof(EdgeQuadVertex),
                     {{color_attribute, 3, offsetof(EdgeQuadVertex, color)}});
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, colors_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, body_->mesh.colors, GL_STATIC_DRAW);
  gl::set_attributes(*gl_, sizeof(glm::vec3), {{color_attribute, 3}});
}

void BodyPass::draw_whole(const Pose& pose) const {
  draw_parts(array_, indices_, {side_begins_, body_->mesh.part_ends}, pose, 0);
}

void BodyPass::draw(const Camera& camera, const Matrix3d& X) const {
  set_stage(picture::stage_uniforms(camera, X, body_->radius), as_drawn);
  gl_->FrontFace(GL_CCW);
  draw_whole({camera, X});
}

void BodyPass::draw_mirrored(const Camera& camera, const Matrix3d& X, double height) const {
  set_stage(picture::mirrored_stage_uniforms(camera, X, body_->radius, height), as_drawn);
  gl_->FrontFace(GL_CW);  // a mirror reverses the winding
  draw_whole({camera, X});
}

void BodyPass::draw_shrunk(const Camera& camera, const Matrix3d& X, const image::Area& pane) {
  if (!silhouette_) silhouette_.emplace(body_->mesh, body_->intersections);
  const Matrix3d body_from_camera = (camera.camera_from_space() * X).inverse();
  const double scale = camera.projection(1, 1) * pane.height / (2 * camera.distance);
  const glm::vec3 eye = picture::glm_from_eigen((camera.distance * body_from_camera.col(2)).eval());
  silhouette_->find(eye, static_cast<float>(scale));
  const picture::Facets seen = visible_facets(body_->mesh, eye, silhouette_->faces_eye());
  lift_ = 1 + scale * seen.depth;
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, visible_indices_.id());
  gl::upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, seen.indices, GL_STREAM_DRAW);
  gl_->BindBuffer(GL_ARRAY_BUFFER, shifts_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, silhouette_->shifts(), GL_STREAM_DRAW);
  set_stage(picture::stage_uniforms(camera, X, body_->radius),
            picture::glm_from_eigen(Vector3d(0.5 * pane.width, 0.5 * pane.height, 0.5)));
  gl_->FrontFace(GL_CCW);
  draw_parts(array_, visible_indices_, {seen.side_begins, seen.part_ends}, {camera, X}, lift_);
}

void BodyPass::draw_edge_quads(const Camera& camera, const Matrix3d& X) const {
  gl_->BindVertexArray(edge_quad_array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, edge_quads_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, silhouette_->edge_quads(), GL_STREAM_DRAW);
  gl::upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, silhouette_->indices(), GL_STREAM_DRAW);
  gl_->Disable(GL_CULL_FACE);
  gl_->DepthMask(GL_FALSE);
  draw_parts(edge_quad_array_, edge_quad_indices_,
             {silhouette_->part_ends(), silhouette_->part_ends()}, {camera, X}, lift_);
  gl_->DepthMask(GL_TRUE);
}

void BodyPass::set_stage(const picture::StageUniforms& stage, const glm::vec3& picture) const {
  for (const gl::Program& program : programs_) {
    program.use();
    program.set("eye", stage.eye);
    program.set("clip_from_stage", stage.clip_from_stage);
    program.set("stage_from_body", stage.stage_from_body);
    program.set("stage_normal_from_body", stage.stage_normal_from_body);
    program.set("picture", picture);
    if (body_->mark) program.set("mark_from_body", *body_->mark);
  }
  gl_->Enable(GL_DEPTH_TEST);
  gl_->Enable(GL_CULL_FACE);
}

/// Draws triangles of `array`, given in indices. If `lift` (pixels) is not 0, parts that touch
/// parts drawn before are lifted over them and fade where they enter them.
void BodyPass::draw_parts(const gl::VertexArray& array, const gl::Buffer& indices,
                          const Ranges& ranges, const Pose& pose, double lift) const {
  gl_->BindVertexArray(array.id());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  std::size_t begin = 0;
  const auto draw_to = [&](const gl::Program& program, std::size_t end, const glm::vec3& side) {
    if (begin == end) return;
    program.set("side_axis", side);
    gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(end - begin), GL_UNSIGNED_INT,
                      gl::offset_pointer(begin * sizeof(std::uint32_t)));
    begin = end;
  };
  for (std::size_t i = 0; i < body_->parts.size(); ++i) {
    const PartModel& part = body_->parts[i];
    const gl::Program& program = programs_[program_of_part_[i]];
    program.use();
    set_occluders(program, part, pose, lift > 0);
    program.set("part_lift", part.is_lifted() ? static_cast<float>(lift) : 0.0F);
    program.set("part_is_solid", part.is_foil ? 0.0F : 1.0F);
    program.set("part_radii", part.radii);
    program.set("across_from_body", part.across_from_body);
    draw_to(program, ranges.side_begins[i], glm::vec3(0));
    draw_to(program, ranges.part_ends[i],
            picture::side_axis_in_stage(*body_, part, pose.camera, pose.X));
  }
  gl_->Disable(GL_BLEND);
}

void BodyPass::set_occluders(const gl::Program& program, const PartModel& part, const Pose& pose,
                             bool smooth) const {
  const auto [from, to, tint] =
      picture::occluder_uniforms(*body_, part, pose.camera, pose.X, smooth);
  if (from.empty()) return;
  program.set("occluders_from", from);
  program.set("occluders_to", to);
  if (!is_of_one_material_) program.set("occluder_tints", tint);
}

}  // namespace twrench::draw
