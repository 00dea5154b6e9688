#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "image/frame.h"
#include "image/image.h"
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

  /// Draws the OpenGL part of a frame. PendingFrame::finish() does the rest, including the
  /// compositing, and may run while other frames are begun. Several frames may be in progress and
  /// may be completed in any order. The renderer must outlive them. `camera`, if given, replaces
  /// the first view's own camera of the body.
  image::PendingFrame begin(timeline::FrameState state,
                            const std::optional<picture::Camera>& camera = {});

  image::Frame draw(timeline::FrameState state) { return begin(std::move(state)).get(); }

  /// Returns how many frames should be in progress before the oldest is completed, so that drawing
  /// does not wait for reading back.
  std::size_t frames_ahead() const;

  /// Returns the camera of the first view, for coordinates in space. The first view shows the body
  /// if any view does.
  picture::Camera camera(const timeline::FrameState& state) const;

 private:
  struct Parts;
  struct Ingredients;

  std::unique_ptr<Parts> parts_;
};

}  // namespace twrench::draw
