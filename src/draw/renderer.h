#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gl/context.h"
#include "gl/readback.h"
#include "image/frame.h"
#include "image/image.h"
#include "image/pending_frame.h"
#include "picture/space/camera.h"
#include "timeline/timeline.h"

namespace twrench::draw {

/// Draws the frames of a scene. Several may share a context; use them only on the thread that
/// created it.
class Renderer {
 public:
  /// Compiles the shaders, creates the meshes and the framebuffer for the scene's frame size, and
  /// draws the static background. Throws InvalidArgument for a size or sample count beyond this
  /// OpenGL's limits, GlError if it lacks a required feature. `mode` defaults to the best one for
  /// this OpenGL.
  Renderer(gl::Context& context, const scene::Scene& scene,
           const std::vector<timeline::Solution>& solutions,
           std::optional<gl::ReadMode> mode = std::nullopt);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Draws a frame with OpenGL; what is drawn without it, and compositing, is left to
  /// PendingFrame::composite(), which may run while other frames are begun. Several frames may be
  /// in progress, and completed in any order. The renderer must outlive them. With `camera`, the
  /// body is seen through that instead of the first view's own.
  image::PendingFrame begin(timeline::FrameState state,
                            const std::optional<picture::Camera>& camera = {});

  image::Frame draw(timeline::FrameState state) { return begin(std::move(state)).get(); }

  /// Returns whether it drew the frame.
  bool drew(const image::Frame& frame) const noexcept;

  /// Takes back a frame that it drew and that is no longer needed, so that a later one can reuse
  /// its memory: only its damaged areas must then be restored. Thread-safe.
  void reuse(image::Frame frame) noexcept;

  /// Returns how many frames should be in progress before the oldest is completed, so that drawing
  /// does not wait for reading back.
  std::size_t frames_ahead() const;

  /// Returns the static background.
  const image::Image& static_background() const;

  /// Returns the camera of the first view, which shows the body if any does, for coordinates in
  /// space.
  picture::Camera camera(const timeline::FrameState& state) const;

 private:
  struct Parts;
  struct Ingredients;

  std::unique_ptr<Parts> parts_;
};

}  // namespace twrench::draw
