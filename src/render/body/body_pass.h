#pragma once

#include <Eigen/Geometry>
#include <glm/vec3.hpp>
#include <optional>

#include "gl/handle.h"
#include "gl/program.h"
#include "image/area.h"
#include "render/body/mesh.h"
#include "render/body/occluders.h"
#include "render/body/revolution.h"
#include "render/body/silhouette.h"
#include "render/look/material.h"
#include "render/look/studio.h"
#include "render/space/camera.h"

namespace twrench::render {

/// Attribute locations of the members of Vertex and EdgeQuadVertex in the body's vertex shader.
enum BodyAttribute : GLuint {
  position_attribute = 0,
  normal_attribute = 1,
  shift_attribute = 2,
  color_attribute = 3,
  fade_attribute = 4
};

/// Draws the body in stage coordinates: the camera's axes, with the body's centre at the origin and
/// its bounding radius scaled to 1. Colour is premultiplied, with alpha 1 on the body.
class BodyPass {
 public:
  /// `radius` is the bounding radius of the parts about the origin in cm; `mesh` is that of the
  /// parts. Each part has a material.
  BodyPass(const gl::Functions& gl, std::span<const body::Part> parts, Mesh mesh, double radius,
           std::span<const Material> materials, const Studio& studio);

  /// Draws the body in the pose X, space_from_body, to the bound framebuffer.
  void draw(const Camera& camera, const Eigen::Matrix3d& X) const;

  /// The same with analytic edge antialiasing, for a framebuffer of one sample per pixel whose
  /// picture fills `pane`: first the body, shrunk by half a pixel along its silhouette, and then,
  /// when all opaque items have been drawn, the edge quads over it.
  void draw_shrunk(const Camera& camera, const Eigen::Matrix3d& X, const image::Area& pane);
  void draw_edge_quads(const Camera& camera, const Eigen::Matrix3d& X) const;

  /// Draws the body's reflection in a horizontal mirror at y = `height` cm in space, below the
  /// camera.
  void draw_mirrored(const Camera& camera, const Eigen::Matrix3d& X, double height) const;

  const Mesh& mesh() const { return mesh_; }
  /// Return the programs: one for each material, and for each that parts with colours of their own
  /// have.
  const std::vector<gl::Program>& programs() const { return programs_; }

 private:
  void add_programs(std::span<const body::Part> parts, std::span<const Material> materials,
                    const Studio& studio);
  void add_colors();
  void set_occluders(const gl::Program& program, const std::vector<Capsule>& capsules,
                     const Eigen::Matrix3d& stage_from_body, bool smooth) const;
  void set_stage(const Camera& camera, const Eigen::Matrix3d& X,
                 const Eigen::Affine3d& seen_from_stage, const glm::vec3& picture) const;
  Eigen::Matrix3d stage_from_body(const Camera& camera, const Eigen::Matrix3d& X) const;
  /// Index ranges: for each part where its side begins, and its end.
  struct Ranges {
    std::span<const std::size_t> side_begins, part_ends;
  };
  void draw_parts(const gl::VertexArray& array, const gl::Buffer& indices, const Ranges& ranges,
                  const Eigen::Matrix3d& stage_from_body, double lift) const;

  const gl::Functions* gl_;
  Mesh mesh_;
  std::vector<std::size_t> side_begins_;         // In the mesh's indices.
  std::vector<std::vector<Capsule>> occluders_;  // occluders of each part
  std::size_t occluder_count_;                   // largest number of occluders of a part
  std::vector<glm::vec3> part_radii_;            // in stage coordinates
  // Unit vectors in body axes; 0 for parts without the side of a cylinder.
  std::vector<Eigen::Vector3d> part_axes_;
  std::vector<AcrossFromBody> across_from_body_;  // of each part
  std::vector<glm::vec4> tints_;                  // of the light that each part reflects
  std::vector<gl::Program> programs_;
  std::vector<std::size_t> program_of_part_;
  bool is_of_one_material_ = true;
  gl::VertexArray array_, edge_quad_array_;
  gl::Buffer vertices_, colors_, indices_, visible_indices_, shifts_;
  gl::Buffer edge_quads_, edge_quad_indices_;
  /// Created by the first draw_shrunk().
  std::optional<Silhouette> silhouette_;
  /// Depth offset towards the eye in pixels, from the last draw_shrunk().
  double lift_ = 0;
  double radius_;
};

}  // namespace twrench::render
