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

/// Attribute locations of the members of Vertex and FinVertex in the body's vertex shader.
enum BodyAttribute : GLuint { position_attribute = 0, normal_attribute = 1, offset_attribute = 2 };

/// Draws the body in stage coordinates: the camera's axes, with the body's centre at the origin and
/// its bounding radius scaled to 1. Colour is premultiplied, with alpha 1 on the body.
class BodyPass {
 public:
  /// `radius` is the bounding radius of the parts about the origin in cm; the facets of the mesh
  /// deviate from the parts by at most `tolerance` cm.
  BodyPass(const gl::Functions& gl, std::span<const Part> parts, double tolerance, double radius,
           const Material& material, const Studio& studio);

  /// Draws the body in the pose X, space_from_body, to the bound framebuffer.
  void draw(const Camera& camera, const Eigen::Matrix3d& X) const;

  /// The same with analytic edge antialiasing, for a framebuffer of one sample per pixel whose
  /// picture fills `pane`: first the body, shrunk by half a pixel along its silhouette, and then,
  /// when all opaque items have been drawn, the edge quads over it.
  void draw_inset(const Camera& camera, const Eigen::Matrix3d& X, const Area& pane);
  void draw_fins(const Camera& camera, const Eigen::Matrix3d& X) const;

  /// Draws the body's reflection in a horizontal mirror at y = `height` cm in space, below the
  /// camera.
  void draw_mirrored(const Camera& camera, const Eigen::Matrix3d& X, double height) const;

  const Mesh& mesh() const { return mesh_; }
  const gl::Program& program() const { return program_; }

 private:
  void set_neighbours(const std::vector<Capsule>& capsules, const Eigen::Matrix3d& stage_from_body,
                      bool smooth) const;
  void set_stage(const Camera& camera, const Eigen::Matrix3d& X,
                 const Eigen::Affine3d& seen_from_stage) const;
  Eigen::Matrix3d stage_from_body(const Camera& camera, const Eigen::Matrix3d& X) const;
  /// Index ranges: for each part where its side begins, and its end.
  struct Ranges {
    std::span<const std::size_t> side_begins, part_ends;
  };
  void draw_parts(const gl::VertexArray& array, const gl::Buffer& indices, const Ranges& ranges,
                  const Eigen::Matrix3d& stage_from_body, double lift) const;

  const gl::Functions* gl_;
  Mesh mesh_;
  std::vector<std::size_t> side_begins_;          // In the mesh's indices.
  std::vector<std::vector<Capsule>> neighbours_;  // occluders of each part
  std::size_t neighbour_count_;                   // largest number of occluders of a part
  std::vector<float> part_radii_;                 // in stage coordinates
  // Unit vectors in body axes; 0 for parts that are not cylinders.
  std::vector<Eigen::Vector3d> part_axes_;
  gl::Program program_;
  gl::VertexArray array_, fin_array_;
  gl::Buffer vertices_, indices_, seen_indices_, offsets_;
  gl::Buffer fins_, fin_indices_;
  /// Created by the first draw_inset().
  std::optional<Outline> outline_;
  /// Depth offset towards the eye in pixels, from the last draw_inset().
  double lift_ = 0;
  double radius_;
};

}  // namespace twrench
