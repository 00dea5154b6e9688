#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "gl/context.h"
#include "image/image.h"
#include "scene/scene.h"

namespace twrench {

/// Draws a scene's body in any pose. One per context; used from the thread that made it.
class Renderer {
 public:
  /// Compiles the shaders, makes the meshes and the framebuffer of the scene's film size.
  /// Throws UsageError for a size or a number of samples that this OpenGL cannot do, GlError when
  /// it lacks what is needed.
  Renderer(gl::Context& context, const Scene& scene);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The frame for the pose X (space_from_body). RGBA when the scene is transparent, else RGB.
  Image draw(const Eigen::Matrix3d& X);

  /// The renderer and version that GL gives: frames are the same bytes where it is the same.
  std::string description() const;

  /// Matrices for column vectors: clip = projection * view * point in space coordinates.
  Eigen::Matrix4d view() const;
  Eigen::Matrix4d projection() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace twrench
