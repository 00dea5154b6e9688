#pragma once

#include <cstddef>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/context.h"
#include "gl/readback.h"
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

/// A frame that has been begun. get() ends it, on the thread of its renderer, which outlives it.
using PendingFrame = std::future<Frame>;

/// Draws a scene's frames. One per context; used from the thread that made it.
class Renderer {
 public:
  /// Compiles the shaders, makes the meshes and the framebuffer of the scene's film size, and
  /// draws what is the same in every frame. Throws UsageError for a size or a number of samples
  /// that this OpenGL cannot do, GlError when it lacks what is needed. `mode` is the best one for
  /// this OpenGL where it is not given.
  Renderer(gl::Context& context, const Scene& scene, const std::vector<Take>& takes,
           std::optional<gl::ReadMode> mode = std::nullopt);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Gives OpenGL all there is to draw; what is to be done with pixels that are on their way then
  /// is left to get(). Frames may be begun before others are ended, and ended in any order.
  PendingFrame begin(const Moment& moment);

  Frame draw(const Moment& moment) { return begin(moment).get(); }

  /// Takes a frame that it drew and that nobody needs any more, so that a later one is drawn in its
  /// memory: only what changed in it has then to be made still again. On any thread.
  void reuse(Frame frame) noexcept;

  /// How many frames should be begun before the one that is being ended, so that drawing does not
  /// wait for what is read back.
  std::size_t frames_ahead() const;

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
