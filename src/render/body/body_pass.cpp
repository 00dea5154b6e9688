#include "render/body/body_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "embedded/shaders.h"
#include "gl/vertices.h"
#include "render/body/facets.h"
#include "render/body/outline_radii.h"
#include "render/body/shader_constants.h"
#include "render/space/glm_from_eigen.h"

namespace twrench::render {
namespace {

using Eigen::Affine3d;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

/// More would cost more at every pixel than they add to the picture.
constexpr std::size_t max_occluders = 3;

std::size_t most_of_any(const std::vector<std::vector<Capsule>>& neighbours) {
  std::size_t most = 0;
  for (const auto& capsules : neighbours) most = std::max(most, capsules.size());
  return most;
}

/// See the uniform part_radii in body.vert.
std::vector<glm::vec3> part_radii(std::span<const body::Part> parts, const Mesh& mesh,
                                  double unit) {
  std::vector<glm::vec3> radii;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [radius, round] = outline_radii(parts[i].shape);
    const double rim = mesh.sides[i] ? mesh.sides[i]->bevel : 0;
    radii.push_back(glm_from_eigen((Vector3d(radius, round, rim) / unit).eval()));
  }
  return radii;
}

/// In indices, where the side of each part begins; the end of the part if it has none.
std::vector<std::size_t> side_begins(const Mesh& mesh) {
  std::vector<std::size_t> begins;
  for (std::size_t part = 0; part < mesh.part_ends.size(); ++part) {
    begins.push_back(mesh.sides[part] ? mesh.sides[part]->begin : mesh.part_ends[part]);
  }
  return begins;
}

/// Unit vectors in body axes; 0 for parts without the side of a cylinder.
std::vector<Vector3d> part_axes(std::span<const body::Part> parts, const Mesh& mesh) {
  std::vector<Vector3d> axes;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    axes.push_back(mesh.sides[i] ? Vector3d(parts[i].body_from_part.col(2)) : Vector3d::Zero());
  }
  return axes;
}

/// What decides on a program beside the studio.
struct ProgramKind {
  Material material;
  bool is_colored;  ///< Whether vertices have colours.

  bool operator==(const ProgramKind&) const = default;
};

bool scatters(const ProgramKind& kind) {
  return kind.is_colored ? kind.material.metalness < 1 : kind.material.diffuse != glm::vec3(0);
}

/// What is compiled into all programs of a body.
struct BodyTraits {
  std::size_t occluder_count;
  bool is_marked, is_of_one_material;
};

/// Whether the body has a diffuse term is compiled in, not tested at each pixel: llvmpipe executes
/// both branches of an if, and the second doubles the work.
gl::Program body_program(const gl::Functions& gl, const ProgramKind& kind, const Studio& studio,
                         const BodyTraits& body) {
  const auto file = [](const char* name) {
    return gl::ShaderFile{name, embedded::shaders().at(name)};
  };
  const std::string constants =
      shader_constants(kind.material, studio) +
      fmt::format("const int occluder_count = {};\nconst bool is_of_one_material = {};\n",
                  body.occluder_count, body.is_of_one_material);
  const bool alone = body.occluder_count == 0;
  const std::array vertex{gl::ShaderFile{"constants", constants},
                          file(alone ? "unoccluded.vert" : "occluders.vert"),
                          file(kind.is_colored ? "colored.vert" : "plain.vert"), file("body.vert")};
  const std::array fragment{gl::ShaderFile{"constants", constants},
                            file("studio.glsl"),
                            file(kind.is_colored ? "colored.glsl" : "plain.glsl"),
                            file(alone ? "unoccluded.glsl" : "occluders.glsl"),
                            file("tone.glsl"),
                            file("brush.glsl"),
                            file(body.is_marked ? "marked.glsl" : "unmarked.glsl"),
                            file(scatters(kind) ? "matte.glsl" : "metal.glsl"),
                            file("body.frag")};
  return {gl, vertex, fragment};
}

/// The colour of the light that a part reflects: of its own, or the mean of its vertices'.
std::vector<glm::vec4> tints(const Mesh& mesh, std::span<const Material> materials) {
  std::vector<glm::vec4> result;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    glm::vec3 color = materials[i].diffuse + materials[i].reflectance;
    if (mesh.is_colored[i] != 0) {
      color =
          std::accumulate(mesh.colors.begin() + static_cast<std::ptrdiff_t>(begin),
                          mesh.colors.begin() + static_cast<std::ptrdiff_t>(mesh.vertex_ends[i]),
                          glm::vec3(0)) /
          static_cast<float>(mesh.vertex_ends[i] - begin);
    }
    result.emplace_back(color, 1);
    begin = mesh.vertex_ends[i];
  }
  return result;
}

/// The shader's `picture` uniform without displacement.
constexpr glm::vec3 as_drawn(1, 1, 0);

/// Returns the matrix that transforms normals with the surface: the cofactor matrix, which for a
/// rotation is the rotation itself, and which is correct for a pose that has left SO(3) too.
Matrix3d normal_matrix(const Matrix3d& m) {
  Matrix3d cofactors;
  cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
  return cofactors;
}

Matrix4d camera_from_stage(const Camera& camera, double radius) {
  Matrix4d result = Matrix4d::Identity();
  result.topLeftCorner<3, 3>() *= radius;
  result(2, 3) = -camera.distance;
  return result;
}

}  // namespace

BodyPass::BodyPass(const gl::Functions& gl, std::span<const body::Part> parts, Mesh mesh,
                   double radius, std::span<const Material> materials, const Studio& studio)
    : gl_(&gl),
      mesh_(std::move(mesh)),
      side_begins_(side_begins(mesh_)),
      occluders_(find_occluders(parts, max_occluders)),
      occluder_count_(most_of_any(occluders_)),
      part_radii_(part_radii(parts, mesh_, radius)),
      part_axes_(part_axes(parts, mesh_)),
      across_from_body_(across_from_body(parts)),
      tints_(tints(mesh_, materials)),
      array_(gl),
      edge_quad_array_(gl),
      vertices_(gl),
      colors_(gl),
      indices_(gl),
      visible_indices_(gl),
      shifts_(gl),
      edge_quads_(gl),
      edge_quad_indices_(gl),
      radius_(radius) {
  add_programs(parts, materials, studio);
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  gl::upload(gl, GL_ELEMENT_ARRAY_BUFFER, mesh_.indices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl::upload(gl, GL_ARRAY_BUFFER, mesh_.vertices, GL_STATIC_DRAW);
  gl::set_attributes(gl, sizeof(Vertex),
                     {{position_attribute, 3, offsetof(Vertex, position)},
                      {normal_attribute, 3, offsetof(Vertex, normal)}});
  gl.BindBuffer(GL_ARRAY_BUFFER, shifts_.id());
  gl::upload(gl, GL_ARRAY_BUFFER, std::vector<Shift>(mesh_.vertices.size()), GL_STREAM_DRAW);
  gl::set_attributes(gl, sizeof(Shift), {{shift_attribute, 4}});

  gl.BindVertexArray(edge_quad_array_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, edge_quad_indices_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, edge_quads_.id());
  gl::set_attributes(gl, sizeof(EdgeQuadVertex),
                     {{position_attribute, 3, offsetof(EdgeQuadVertex, position)},
                      {normal_attribute, 3, offsetof(EdgeQuadVertex, normal)},
                      {shift_attribute, 4, offsetof(EdgeQuadVertex, shift)},
                      {fade_attribute, 2, offsetof(EdgeQuadVertex, transparency)}});
  if (!mesh_.colors.empty()) add_colors();
}

void BodyPass::add_programs(std::span<const body::Part> parts, std::span<const Material> materials,
                            const Studio& studio) {
  std::vector<ProgramKind> kinds;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ProgramKind kind{materials[i], mesh_.is_colored[i] != 0};
    const auto found = std::ranges::find(kinds, kind);
    program_of_part_.push_back(static_cast<std::size_t>(found - kinds.begin()));
    if (found == kinds.end()) kinds.push_back(kind);
  }
  is_of_one_material_ = kinds.size() == 1 && !kinds.front().is_colored;
  const BodyTraits traits{occluder_count_, axis_of_revolution(parts).has_value(),
                          is_of_one_material_};
  for (const ProgramKind& kind : kinds) {
    programs_.push_back(body_program(*gl_, kind, studio, traits));
  }
}

/// Makes both vertex arrays, of which that of the edge quads is bound, read colours.
void BodyPass::add_colors() {
  gl::set_attributes(*gl_, sizeof(EdgeQuadVertex),
                     {{color_attribute, 3, offsetof(EdgeQuadVertex, color)}});
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, colors_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, mesh_.colors, GL_STATIC_DRAW);
  gl::set_attributes(*gl_, sizeof(glm::vec3), {{color_attribute, 3}});
}

void BodyPass::draw(const Camera& camera, const Matrix3d& X) const {
  set_stage(camera, X, Affine3d::Identity(), as_drawn);
  gl_->FrontFace(GL_CCW);
  draw_parts(array_, indices_, {side_begins_, mesh_.part_ends}, stage_from_body(camera, X), 0);
}

void BodyPass::draw_mirrored(const Camera& camera, const Matrix3d& X, double height) const {
  Affine3d mirror = Affine3d::Identity();  // in space, in stage units
  mirror(1, 1) = -1;
  mirror(1, 3) = 2 * height / radius_;
  const Affine3d stage_from_space(camera.camera_from_space());
  set_stage(camera, X, stage_from_space * mirror * stage_from_space.inverse(), as_drawn);
  gl_->FrontFace(GL_CW);  // a mirror reverses the winding
  draw_parts(array_, indices_, {side_begins_, mesh_.part_ends}, stage_from_body(camera, X), 0);
}

void BodyPass::draw_shrunk(const Camera& camera, const Matrix3d& X, const image::Area& pane) {
  if (!silhouette_) silhouette_.emplace(mesh_);
  const Matrix3d body_from_camera = (camera.camera_from_space() * X).inverse();
  const double scale = camera.projection(1, 1) * pane.height / (2 * camera.distance);
  const glm::vec3 eye = glm_from_eigen((camera.distance * body_from_camera.col(2)).eval());
  silhouette_->find(eye, static_cast<float>(scale));
  const Facets seen = visible_facets(mesh_, eye, silhouette_->faces_eye());
  lift_ = 1 + scale * seen.depth;
  gl_->BindVertexArray(array_.id());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, visible_indices_.id());
  gl::upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, seen.indices, GL_STREAM_DRAW);
  gl_->BindBuffer(GL_ARRAY_BUFFER, shifts_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, silhouette_->shifts(), GL_STREAM_DRAW);
  set_stage(camera, X, Affine3d::Identity(),
            glm_from_eigen(Vector3d(0.5 * pane.width, 0.5 * pane.height, 0.5)));
  gl_->FrontFace(GL_CCW);
  draw_parts(array_, visible_indices_, {seen.side_begins, seen.part_ends},
             stage_from_body(camera, X), lift_);
}

void BodyPass::draw_edge_quads(const Camera& camera, const Matrix3d& X) const {
  gl_->BindVertexArray(edge_quad_array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, edge_quads_.id());
  gl::upload(*gl_, GL_ARRAY_BUFFER, silhouette_->edge_quads(), GL_STREAM_DRAW);
  gl::upload(*gl_, GL_ELEMENT_ARRAY_BUFFER, silhouette_->indices(), GL_STREAM_DRAW);
  gl_->Disable(GL_CULL_FACE);
  gl_->DepthMask(GL_FALSE);
  draw_parts(edge_quad_array_, edge_quad_indices_,
             {silhouette_->part_ends(), silhouette_->part_ends()}, stage_from_body(camera, X),
             lift_);
  gl_->DepthMask(GL_TRUE);
}

Matrix3d BodyPass::stage_from_body(const Camera& camera, const Matrix3d& X) const {
  return camera.camera_from_space() * X / radius_;
}

/// The body stays in stage coordinates, in its light; the camera sees the stage transformed by
/// `seen_from_stage`, which is its own inverse.
void BodyPass::set_stage(const Camera& camera, const Matrix3d& X, const Affine3d& seen_from_stage,
                         const glm::vec3& picture) const {
  const Vector3d eye = seen_from_stage * Vector3d(0, 0, camera.distance / radius_);
  const Matrix4d clip_from_stage =
      camera.projection * camera_from_stage(camera, radius_) * seen_from_stage.matrix();
  const Matrix3d turn = normal_matrix(camera.camera_from_space() * X);
  for (const gl::Program& program : programs_) {
    program.use();
    program.set("eye", glm_from_eigen(eye));
    program.set("clip_from_stage", glm_from_eigen(clip_from_stage));
    program.set("stage_from_body", glm_from_eigen(stage_from_body(camera, X)));
    program.set("stage_normal_from_body", glm_from_eigen(turn));
    program.set("picture", picture);
  }
  gl_->Enable(GL_DEPTH_TEST);
  gl_->Enable(GL_CULL_FACE);
}

/// Draws triangles of `array`, given in indices. With `lift` in pixels, parts that touch parts
/// drawn before are lifted over them and fade where they enter them; not with 0.
void BodyPass::draw_parts(const gl::VertexArray& array, const gl::Buffer& indices,
                          const Ranges& ranges, const Matrix3d& stage_from_body,
                          double lift) const {
  gl_->BindVertexArray(array.id());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  std::size_t begin = 0;
  const auto draw_to = [&](const gl::Program& program, std::size_t end, const Vector3d& side_axis) {
    if (begin == end) return;
    program.set("side_axis", glm_from_eigen((radius_ * stage_from_body * side_axis).eval()));
    gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(end - begin), GL_UNSIGNED_INT,
                      gl::offset_pointer(begin * sizeof(std::uint32_t)));
    begin = end;
  };
  for (std::size_t part = 0; part < ranges.part_ends.size(); ++part) {
    const gl::Program& program = programs_[program_of_part_[part]];
    program.use();
    set_occluders(program, occluders_[part], stage_from_body, lift > 0);
    const bool meets = std::ranges::any_of(occluders_[part], &Capsule::meets);
    program.set("part_lift", meets ? static_cast<float>(lift) : 0.0F);
    program.set("part_radii", part_radii_[part]);
    program.set("across_from_body", across_from_body_[part]);
    draw_to(program, ranges.side_begins[part], Vector3d::Zero());
    draw_to(program, ranges.part_ends[part], part_axes_[part]);
  }
  gl_->Disable(GL_BLEND);
}

void BodyPass::set_occluders(const gl::Program& program, const std::vector<Capsule>& capsules,
                             const Matrix3d& stage_from_body, bool smooth) const {
  if (occluder_count_ == 0) return;
  // Unused occluder slots: too small and far away to be visible.
  std::vector<glm::vec4> from(occluder_count_, glm::vec4(0, 0, -1e4F, 1e-6F));
  std::vector<glm::vec4> to(occluder_count_, glm::vec4(0, 1, -1e4F, 0));
  std::vector<glm::vec4> tint(occluder_count_, glm::vec4(1));
  for (std::size_t i = 0; i < capsules.size(); ++i) {
    const auto end = [&](const Vector3d& place) {
      return glm_from_eigen((stage_from_body * place).eval());
    };
    from[i] = glm::vec4(end(capsules[i].from), capsules[i].radius / radius_);
    to[i] = glm::vec4(end(capsules[i].to), smooth && capsules[i].meets ? 1 : 0);
    tint[i] = tints_[capsules[i].part];
  }
  program.set("occluders_from", from);
  program.set("occluders_to", to);
  if (!is_of_one_material_) program.set("occluder_tints", tint);
}

}  // namespace twrench::render
