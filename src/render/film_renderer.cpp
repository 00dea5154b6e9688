#include "render/film_renderer.h"

#include <twrench/base/error.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "canvas/font.h"
#include "render/compose/layout.h"
#include "render/cross_fade.h"
#include "render/hud/caption.h"
#include "render/look/theme.h"

namespace twrench::render {
namespace {

/// Throws if the shot has no layout, or a caption that cannot be set.
void require_drawable(const scene::Shot& shot, const canvas::Typeface& typeface) {
  try {
    const Layout layout = compute_layout(shot.scene);
    const OverlayColors& colors = style_of(shot.scene.look.theme).overlay;
    if (layout.caption) Caption(*shot.scene.caption, *layout.caption, typeface, colors);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(shot.place, error.what(), error.remedy());
  }
}

/// Completes both frames, and returns the one as it fades into the other.
image::Frame faded(image::Frame from, image::Frame to, double share) {
  to.image = cross_fade(from.image, to.image, share);
  to.damage.assign(1, {0, 0, to.image.width, to.image.height});
  return to;
}

}  // namespace

FilmRenderer::FilmRenderer(gl::Context& context, const scene::Scene& film)
    : context_(context), film_(film) {
  const canvas::Typeface typeface = canvas::load_typeface(film.overlay.font);
  typeface_digest_ = canvas::typeface_digest(typeface);
  for (const scene::Shot& shot : film.shots) require_drawable(shot, typeface);
}

/// Gives up the shots that the frame does not show. One that is still being completed remains until
/// then.
void FilmRenderer::leave_others(const timeline::FilmFrame& frame) {
  const std::lock_guard lock(mutex_);
  std::erase_if(stages_, [&](const auto& stage) {
    return stage->shot != frame.shot && !(frame.previous && stage->shot + 1 == frame.shot);
  });
}

std::shared_ptr<FilmRenderer::Stage> FilmRenderer::stage(const timeline::FilmTimeline& timeline,
                                                         std::size_t shot) {
  const auto found = std::ranges::find_if(
      stages_, [&](const std::shared_ptr<Stage>& stage) { return stage->shot == shot; });
  if (found != stages_.end()) return *found;
  const scene::Scene& scene = timeline::scene_of_shot(film_, shot);
  auto made =
      std::make_shared<Stage>(Stage{shot, Renderer(context_, scene, timeline.solutions(shot))});
  const std::lock_guard lock(mutex_);
  stages_.push_back(made);
  return made;
}

Camera FilmRenderer::camera(const timeline::FilmTimeline& timeline,
                            const timeline::FilmFrame& frame) {
  leave_others(frame);
  const Camera own = stage(timeline, frame.shot)->renderer.camera(frame.state);
  if (frame.moved == 1) return own;
  const auto before = stage(timeline, frame.shot - 1);
  return between(before->renderer.camera(*frame.previous), own, frame.moved);
}

PendingFrame FilmRenderer::begin(const timeline::FilmTimeline& timeline,
                                 const timeline::FilmFrame& frame) {
  leave_others(frame);
  const auto own = stage(timeline, frame.shot);
  std::optional<Camera> moving;
  if (frame.moved < 1) moving = camera(timeline, frame);
  PendingFrame pending = own->renderer.begin(frame.state, moving);
  if (frame.faded == 1) {
    return std::async(std::launch::deferred,
                      [own, pending = std::move(pending)]() mutable { return pending.get(); });
  }
  const auto before = stage(timeline, frame.shot - 1);
  PendingFrame from = before->renderer.begin(*frame.previous, moving);
  return std::async(std::launch::deferred, [own, before, pending = std::move(pending),
                                            from = std::move(from), share = frame.faded]() mutable {
    return faded(from.get(), pending.get(), share);
  });
}

void FilmRenderer::reuse(image::Frame frame) noexcept {
  const std::lock_guard lock(mutex_);
  for (const auto& stage : stages_) {
    if (stage->renderer.drew(frame)) return stage->renderer.reuse(std::move(frame));
  }
}

std::size_t FilmRenderer::frames_ahead() const {
  return gl::best_read_mode(gl::Functions(context_)) == gl::ReadMode::buffered ? 1 : 0;
}

std::string FilmRenderer::description() const {
  return gl::renderer_string(gl::Functions(context_));
}

}  // namespace twrench::render
