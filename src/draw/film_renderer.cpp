#include "draw/film_renderer.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "canvas/font.h"
#include "draw/exposure.h"
#include "picture/compose/layout.h"
#include "picture/hud/caption.h"
#include "picture/look/theme.h"

namespace twrench::draw {
namespace {

/// Returns whether the picture of the shot has room for its caption, if it has one. Throws if the
/// shot has no layout, or if its caption cannot be set.
bool has_room_for_caption(const scene::Shot& shot, const canvas::Typeface& typeface) {
  try {
    const picture::Layout layout = picture::compute_layout(shot.scene);
    const picture::OverlayColors& colors = picture::style_of(shot.scene.look.theme).overlay;
    if (layout.caption) picture::Caption(*shot.scene.caption, *layout.caption, typeface, colors);
    return layout.caption || !shot.scene.caption;
  } catch (const canvas::MissingGlyph& error) {
    throw canvas::MissingGlyph(shot.place, error.what(), error.character());
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(shot.place, error.what(), error.remedy());
  }
}

/// Composites both frames and returns the fade from the first to the second.
image::Frame faded(const image::PendingFrame& from, const image::PendingFrame& to, double share) {
  const image::Frame before = from.finish();
  image::Frame frame = to.finish();
  frame.image = cross_fade(before.image, frame.image, share);
  frame.damage.assign(1, {0, 0, frame.image.width, frame.image.height});
  return frame;
}

}  // namespace

FilmRenderer::FilmRenderer(gl::Context& context, const scene::Scene& film)
    : context_(context), film_(film) {
  const canvas::Typeface typeface = canvas::load_typeface(film.overlay.font);
  typeface_digest_ = canvas::typeface_digest(typeface);
  for (const scene::Shot& shot : film.shots) {
    if (has_room_for_caption(shot, typeface) || caption_warning_) continue;
    caption_warning_ =
        fmt::format("{}.caption: is left out, because a picture of {}x{} is too small for captions",
                    shot.place, shot.scene.film.width, shot.scene.film.height);
  }
}

/// Destroys the renderers of the shots that neither the frame shows nor a frame in progress uses.
/// This happens on the drawing thread, because their OpenGL objects are destroyed with them.
void FilmRenderer::leave_others(const timeline::FilmFrame& frame) {
  std::erase_if(stages_, [&](const auto& stage) {
    return stage->shot != frame.shot && !(frame.previous && stage->shot + 1 == frame.shot) &&
           stage.use_count() == 1;
  });
}

std::shared_ptr<FilmRenderer::Stage> FilmRenderer::stage(const timeline::FilmTimeline& timeline,
                                                         std::size_t shot) {
  const auto found = std::ranges::find_if(
      stages_, [&](const std::shared_ptr<Stage>& stage) { return stage->shot == shot; });
  if (found != stages_.end()) return *found;
  const scene::Scene& scene = timeline::scene_of_shot(film_, shot);
  stages_.push_back(
      std::make_shared<Stage>(Stage{shot, Renderer(context_, scene, timeline.solutions(shot))}));
  return stages_.back();
}

picture::Camera FilmRenderer::camera(const timeline::FilmTimeline& timeline,
                                     const timeline::FilmFrame& frame) {
  leave_others(frame);
  const picture::Camera own = stage(timeline, frame.shot)->renderer.camera(frame.state);
  if (frame.moved == 1) return own;
  const auto before = stage(timeline, frame.shot - 1);
  return picture::between(before->renderer.camera(*frame.previous), own, frame.moved);
}

image::PendingFrame FilmRenderer::begin(const timeline::FilmTimeline& timeline,
                                        timeline::FilmFrame frame, const picture::Camera& camera) {
  leave_others(frame);
  std::optional<picture::Camera> moving;
  if (frame.moved < 1) moving = camera;
  const auto draw = [&](std::size_t shot, timeline::FrameState state) -> image::PendingFrame {
    const std::shared_ptr<Stage> drawing = stage(timeline, shot);
    const image::PendingFrame drawn = drawing->renderer.begin(std::move(state), moving);
    // Captured, so that the shot lives as long as the frame is in progress.
    return {drawn.fetch, [drawing, drawn] { return drawn.finish(); }};
  };
  const image::PendingFrame own = draw(frame.shot, std::move(frame.state));
  if (frame.faded == 1) return own;
  const image::PendingFrame previous = draw(frame.shot - 1, std::move(*frame.previous));
  const auto fetch = [own, previous] {
    own.fetch();
    previous.fetch();
  };
  return {fetch, [own, previous, share = frame.faded] { return faded(previous, own, share); }};
}

std::size_t FilmRenderer::frames_ahead() const {
  return gl::best_read_mode(gl::Functions(context_)) == gl::ReadMode::buffered ? 1 : 0;
}

std::string FilmRenderer::description() const {
  return gl::renderer_string(gl::Functions(context_));
}

}  // namespace twrench::draw
