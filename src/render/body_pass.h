#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "gl/handle.h"
#include "gl/program.h"
#include "image/area.h"
#include "render/camera.h"
#include "render/material.h"
#include "render/mesh.h"
#include "render/neighbours.h"
#include "render/outline.h"
#include "render/studio.h"

namespace twrench {

/// Where the vertex shader of the body takes the members of a Vertex and of a FinVertex.
enum BodyAttribute : GLuint { position_attribute = 0, normal_attribute = 1, offset_attribute = 2 };

/// Draws the body on the stage: the camera's axes, the body's centre at the origin, its bounding
/// radius 1. Colour is premultiplied, with alpha 1 on the body.
class BodyPass {
 public:
  /// `radius` is the bounding radius of the parts about the origin, in cm; the facets of the mesh
  /// depart from the parts by no more than `tolerance` cm.
  BodyPass(const gl::Functions& gl, std::span<const Part> parts, double tolerance, double radius,
           const Material& material, const Studio& studio);

  /// In the pose X, space_from_body, on the framebuffer that is bound.
  void draw(const Camera& camera, const Eigen::Matrix3d& X) const;

  /// The same with smooth edges, for a framebuffer of one sample a pixel whose picture fills
  /// `pane`: first the body, drawn in by half a pixel where its outline is, then, when all that is
  /// solid has been drawn, the fins over its edge.
  void draw_inset(const Camera& camera, const Eigen::Matrix3d& X, const Area& pane);
  void draw_fins(const Camera& camera, const Eigen::Matrix3d& X) const;

  /// As a mirror shows it that lies level at y = `height` cm in space, below the camera.
  void draw_mirrored(const Camera& camera, const Eigen::Matrix3d& X, double height) const;

  const Mesh& mesh() const { return mesh_; }
  const gl::Program& program() const { return program_; }

 private:
  void set_neighbours(const std::vector<Capsule>& capsules, const Eigen::Matrix3d& stage_from_body,
                      bool smooth) const;
  void set_stage(const Camera& camera, const Eigen::Matrix3d& X,
                 const Eigen::Affine3d& seen_from_stage) const;
  Eigen::Matrix3d stage_from_body(const Camera& camera, const Eigen::Matrix3d& X) const;
  /// In indices: of each part where its side begins, and its end.
  struct Ranges {
    std::span<const std::size_t> side_begins, part_ends;
  };
  void draw_parts(const gl::VertexArray& array, const gl::Buffer& indices, const Ranges& ranges,
                  const Eigen::Matrix3d& stage_from_body, double lift) const;

  const gl::Functions* gl_;
  Mesh mesh_;
  std::vector<std::size_t> side_begins_;          // in the mesh's indices
  std::vector<std::vector<Capsule>> neighbours_;  // of each part
  std::size_t neighbour_count_;                   // the most of any
  std::vector<float> part_radii_;                 // stage
  std::vector<Eigen::Vector3d> part_axes_;        // unit, body axes; 0 for what is no cylinder
  gl::Program program_;
  gl::VertexArray array_, fin_array_;
  gl::Buffer vertices_, indices_, seen_indices_, offsets_;
  gl::Buffer fins_, fin_indices_;
  std::optional<Outline> outline_;  ///< once draw_inset() was asked for
  double lift_ = 0;                 ///< pixels, as draw_inset() drew
  double radius_;
};

}  // namespace twrench
