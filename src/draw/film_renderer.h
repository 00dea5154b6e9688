#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draw/renderer.h"
#include "timeline/film_timeline.h"

namespace twrench::draw {

/// Draws the frames of a film, with or without shots. Each shot has its own renderer, which is
/// created when a frame needs it and destroyed once no frame uses it. Use the film renderer only on
/// the thread that created it.
class FilmRenderer {
 public:
  /// Examines the layout and the text of all shots. Throws InvalidArgument about a shot that cannot
  /// be drawn. The context and the film must outlive the renderer.
  FilmRenderer(gl::Context& context, const scene::Scene& film);

  /// Returns a warning if the pictures are too small for the captions of the shots, so that these
  /// are left out.
  const std::optional<std::string>& caption_warning() const { return caption_warning_; }

  /// Returns the camera of the frame's first view. If a shot begins with the frame, throws as
  /// Renderer() does.
  picture::Camera camera(const timeline::FilmTimeline& timeline, const timeline::FilmFrame& frame);

  /// Begins a frame of the timeline, as Renderer::begin() does. `camera` is the frame's camera.
  /// Throws as camera() does.
  image::PendingFrame begin(const timeline::FilmTimeline& timeline, timeline::FilmFrame frame,
                            const picture::Camera& camera);

  image::Frame draw(const timeline::FilmTimeline& timeline, const timeline::FilmFrame& frame) {
    return begin(timeline, frame, camera(timeline, frame)).get();
  }

  /// Returns how many frames should be in progress before the oldest is completed.
  std::size_t frames_ahead() const;

  /// Returns GL's renderer and version. If they are the same, frames are byte-identical.
  std::string description() const;

  /// Returns a digest of the font files' bytes; frames depend on it too.
  std::string typeface_digest() const { return typeface_digest_; }

 private:
  /// A shot that is being drawn.
  struct Stage {
    std::size_t shot;
    Renderer renderer;
  };

  void leave_others(const timeline::FilmFrame& frame);
  std::shared_ptr<Stage> stage(const timeline::FilmTimeline& timeline, std::size_t shot);

  gl::Context& context_;
  const scene::Scene& film_;
  std::string typeface_digest_;
  std::optional<std::string> caption_warning_;
  std::vector<std::shared_ptr<Stage>> stages_;  ///< A few at most.
};

}  // namespace twrench::draw
