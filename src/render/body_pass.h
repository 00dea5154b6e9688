#pragma once

#include <Eigen/Core>

#include "gl/handle.h"
#include "gl/program.h"
#include "render/camera.h"
#include "render/material.h"
#include "render/mesh.h"
#include "render/studio.h"

namespace twrench {

/// Where the vertex shader of the body takes the members of a Vertex.
enum BodyAttribute : GLuint { position_attribute = 0, normal_attribute = 1 };

/// Draws the body on the stage: the camera's axes, the body's centre at the origin, its bounding
/// radius 1. Colour is premultiplied, with alpha 1 on the body.
class BodyPass {
 public:
  /// `radius` is the mesh's bounding radius about the origin, in cm.
  BodyPass(const gl::Functions& gl, const Mesh& mesh, double radius, const Material& material,
           const Studio& studio);

  /// In the pose X, space_from_body, on the framebuffer that is bound.
  void draw(const Camera& camera, const Eigen::Matrix3d& X) const;

  const gl::Program& program() const { return program_; }

 private:
  void set_material(const Material& material) const;
  void set_studio(const Studio& studio) const;

  const gl::Functions* gl_;
  gl::Program program_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
  GLsizei index_count_;
  double radius_;
};

}  // namespace twrench
