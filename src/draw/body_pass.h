#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "gl/program.h"
#include "image/area.h"
#include "picture/body/body_model.h"
#include "picture/body/body_uniforms.h"
#include "picture/body/silhouette.h"
#include "picture/space/camera.h"

namespace twrench::draw {

/// Attribute locations of the members of Vertex and EdgeQuadVertex in the body's vertex shader.
enum BodyAttribute : GLuint {
  position_attribute = 0,
  normal_attribute = 1,
  shift_attribute = 2,
  color_attribute = 3,
  fade_attribute = 4
};

/// Draws the body. Colour is premultiplied, with alpha 1 on the body.
class BodyPass {
 public:
  /// The body must outlive the pass.
  BodyPass(const gl::Functions& gl, const picture::BodyModel& body);

  /// Draws the body in the pose X, space_from_body, to the bound framebuffer.
  void draw(const picture::Camera& camera, const Eigen::Matrix3d& X) const;

  /// The same with analytic edge antialiasing, for a framebuffer with one sample per pixel whose
  /// picture fills `pane`. draw_shrunk() draws the body, shrunk by half a pixel along its
  /// silhouette. When all opaque items have been drawn, draw_edge_quads() draws the edge quads over
  /// it.
  void draw_shrunk(const picture::Camera& camera, const Eigen::Matrix3d& X,
                   const image::Area& pane);
  void draw_edge_quads(const picture::Camera& camera, const Eigen::Matrix3d& X) const;

  /// Draws the body's reflection in a horizontal mirror at y = `height` cm in space, below the
  /// camera.
  void draw_mirrored(const picture::Camera& camera, const Eigen::Matrix3d& X, double height) const;

  /// Return the programs: one for each combination of a material and the presence of vertex
  /// colours.
  const std::vector<gl::Program>& programs() const { return programs_; }

 private:
  void add_programs();
  void add_colors();
  void set_stage(const picture::StageUniforms& stage, const glm::vec3& picture) const;
  /// Index ranges: the beginning of the side and the end of each part.
  struct Ranges {
    std::span<const std::size_t> side_begins, part_ends;
  };
  /// The camera and the pose X in which parts are drawn.
  struct Pose {
    const picture::Camera& camera;
    const Eigen::Matrix3d& X;
  };
  void draw_parts(const gl::VertexArray& array, const gl::Buffer& indices, const Ranges& ranges,
                  const Pose& pose, double lift) const;
  void draw_whole(const Pose& pose) const;
  void set_occluders(const gl::Program& program, const picture::PartModel& part, const Pose& pose,
                     bool smooth) const;

  const gl::Functions* gl_;
  const picture::BodyModel* body_;
  std::vector<std::size_t> side_begins_;  ///< For each part, in the mesh's indices.
  std::vector<gl::Program> programs_;
  std::vector<std::size_t> program_of_part_;
  bool is_of_one_material_ = true;
  gl::VertexArray array_, edge_quad_array_;
  gl::Buffer vertices_, colors_, indices_, visible_indices_, shifts_;
  gl::Buffer edge_quads_, edge_quad_indices_;
  /// Created by the first draw_shrunk().
  std::optional<picture::Silhouette> silhouette_;
  /// Depth offset towards the eye in pixels, from the last draw_shrunk().
  double lift_ = 0;
};

}  // namespace twrench::draw
