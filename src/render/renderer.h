#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/context.h"
#include "image/area.h"
#include "image/image.h"
#include "render/camera.h"
#include "timeline/timeline.h"

namespace twrench {

/// A frame, and where it differs from what is the same in all frames.
struct Frame {
  Image image;                ///< RGBA when the scene is transparent, else RGB
  std::vector<Area> changed;  ///< may overlap
};

/// Draws a scene's frames. One per context; used from the thread that made it.
class Renderer {
 public:
  /// Compiles the shaders, makes the meshes and the framebuffer of the scene's film size, and
  /// draws what is the same in every frame. Throws UsageError for a size or a number of samples
  /// that this OpenGL cannot do, GlError when it lacks what is needed.
  Renderer(gl::Context& context, const Scene& scene, const std::vector<Take>& takes);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  Frame draw(const Moment& moment);

  /// The picture before anything that changes is laid over it.
  const Image& still() const;

  /// The renderer and version that GL gives: frames are the same bytes where it is the same.
  std::string description() const;

  /// That of the first view, `film_time` seconds into the film: of the body, if it is shown.
  Camera camera(double film_time) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace twrench
