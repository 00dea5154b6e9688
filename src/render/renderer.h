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

/// A frame and its damaged areas, where it differs from the static background.
struct Frame {
  Image image;                ///< RGBA if the scene is transparent, otherwise RGB.
  std::vector<Area> changed;  ///< May overlap.
};

/// A frame in progress. get() completes it on the thread of its renderer, which must outlive it.
using PendingFrame = std::future<Frame>;

/// Draws the frames of a scene. One per context; use it only on the thread that created it.
class Renderer {
 public:
  /// Compiles the shaders, creates the meshes and the framebuffer for the scene's frame size, and
  /// draws the static background. Throws UsageError for a size or sample count beyond this OpenGL's
  /// limits, GlError if it lacks a required feature. `mode` defaults to the best one for this
  /// OpenGL.
  Renderer(gl::Context& context, const Scene& scene, const std::vector<Take>& takes,
           std::optional<gl::ReadMode> mode = std::nullopt);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Issues all drawing of a frame; work on pixels that are still in transfer is left to get().
  /// Several frames may be in progress, and completed in any order.
  PendingFrame begin(const Moment& moment);

  Frame draw(const Moment& moment) { return begin(moment).get(); }

  /// Takes back a frame that it drew and that is no longer needed, so that a later one can reuse
  /// its memory: only its damaged areas must then be restored. Thread-safe.
  void reuse(Frame frame) noexcept;

  /// Returns how many frames should be in progress before the oldest is completed, so that drawing
  /// does not wait for reading back.
  std::size_t frames_ahead() const;

  /// Returns the static background.
  const Image& still() const;

  /// Returns GL's renderer and version; frames are byte-identical where these are the same.
  std::string description() const;

  /// Returns the camera of the first view, which shows the body if any does, `film_time` seconds
  /// into the video.
  Camera camera(double film_time) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace twrench
