#include "picture/views/body_view.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <iterator>

#include "picture/body/bounding_radius.h"
#include "picture/compose/camera_path.h"
#include "scene/reference_frame.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;

/// Returns the overlay that shows the feature, if the scene does.
template <typename Shown>
std::optional<Shown> shown_if(scene::Feature feature, const scene::Scene& scene,
                              const timeline::Solution& solution, double radius) {
  if (!scene.overlay.shows(feature)) return std::nullopt;
  return Shown(scene, solution, radius);
}

/// Tolerance in cm at which facets are indistinguishable from the shape: a seventh of a pixel in
/// the middle of the picture.
double tolerance(const Camera& camera, int height) {
  return 0.15 * 2 * camera.distance / (camera.projection(1, 1) * height);
}

}  // namespace

BodyView::BodyView(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                   std::size_t solution, const Layout::Pane& pane, double radius)
    : View(pane),
      solution_(solution),
      motion_(solutions[solution].body),
      frame_(scene.camera.frame),
      radius_(radius),
      overlay_(scene, solutions[solution].body, radius_),
      forces_(shown_if<ForceArrows>(scene::Feature::forces, scene, solutions[solution], radius_)),
      torques_(shown_if<TorqueArcs>(scene::Feature::torques, scene, solutions[solution], radius_)),
      tip_(shown_if<AxisTip>(scene::Feature::tip, scene, solutions[solution], radius_)),
      path_(scene.camera),
      framing_(framing_of(scene, solutions[solution])),
      turns_(frame_ != scene::Frame::space || path_.orbit != 0 ||
             scene.overlay.star_trail.value_or(0) > 0),
      half_open_(0.25 / scene.film.fps),
      speed_(scene.film.speed) {
  add_surroundings(scene);
}

BodyView::BodyView(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                   std::size_t solution, const Layout::Pane& pane)
    : BodyView(scene, solutions, solution, pane,
               bounding_radius(scene::visible_parts(scene.body))) {
  body_ = body_model(scene, tolerance(camera(0), pane.area.height), radius_);
  if (scene.look.motion_blur > 1) {
    sampling_.emplace(scene::visible_parts(scene.body), body_.mesh, radius_);
  }
}

/// Adds the stars of the theme, and the floor or its shadow alone or, for a camera that turns with
/// its frame, stars instead of the floor.
void BodyView::add_surroundings(const scene::Scene& scene) {
  const bool shows_floor = scene.overlay.shows(scene::Feature::floor) && !scene.look.transparent;
  const bool turns_with_frame = frame_ != scene::Frame::space;
  if (FixedStars::are_of_theme(scene) || (turns_with_frame && shows_floor)) {
    stars_.emplace(scene, pane().area.height);
  }
  if (turns_with_frame) return;
  if (scene.camera.elevation < 0) return;
  std::optional<FloorStyle> floor = style_of(scene.look.theme).floor;
  if (shows_floor && floor) {
    const bool is_lit = !scene.look.background;
    if (!is_lit || scene.camera.orbit == 0) floor->clouds = 0;
    floor_ = Floor{*floor, is_lit};
  } else if (scene.overlay.shows(scene::Feature::shadow)) {
    constexpr double usual_shadow = 0.5;  // for a theme without a floor
    floor_ = Floor{
        {.light = {}, .shadow = floor ? floor->shadow : usual_shadow, .reflection = 0, .clouds = 0},
        false};
  }
}

/// Returns the radius in cm of a sphere that contains everything that turns with the body.
double BodyView::shown_radius() const {
  return std::max(overlay_.bounding_radius(), torques_ ? torques_->bounding_radius() : 0.0);
}

/// Returns the framing, the same throughout the video, that keeps the overlay in view at all times.
Framing BodyView::framing_of(const scene::Scene& scene, const timeline::Solution& solution) const {
  std::vector<Eigen::Vector3d> points;
  if (forces_) points = forces_->extent();
  if (tip_) std::ranges::copy(tip_->extent(), std::back_inserter(points));
  constexpr std::size_t stride = 12;  // of the samples, which are finer than needed here
  for (std::size_t i = 0; i < solution.whole.size(); i += stride) {
    const Matrix3d frame_from_space =
        scene::reference_frame(frame_, motion_, solution.whole[i]).attitude.transpose();
    for (const Eigen::Vector3d& p : overlay_.extent()) points.emplace_back(frame_from_space * p);
    if (frame_ == scene::Frame::space) break;  // there they are at rest
  }
  const double aspect = static_cast<double>(pane().focus.width) / pane().focus.height;
  return framing_along(scene, aspect, shown_radius(), points);
}

Viewpoint BodyView::viewpoint(double video_time) const {
  return {path_.azimuth + path_.orbit * video_time, path_.elevation};
}

Camera BodyView::camera_from(const Viewpoint& from) const {
  return widened(frame_sphere(seen_from(framing_, from)), pane().focus, pane().area);
}

/// Returns the attitude of the camera's frame of reference at a time in the video, at which the
/// motion is at `sample`.
Matrix3d BodyView::frame_at(const timeline::FrameState& state, double video_time,
                            const motion::Sample& sample) const {
  if (state.move && state.move->change) {
    const double since = state.move_time + (video_time - state.video_time);
    return state.move->change->attitude(since, sample);
  }
  return scene::reference_frame(frame_, motion_, sample).attitude;
}

/// Returns the attitude of the camera at a time in the video.
Matrix3d BodyView::camera_from_space(const timeline::FrameState& state, double video_time,
                                     const motion::Sample& sample) const {
  Matrix3d camera_from_frame = camera(video_time).camera_from_space();
  const double since = state.move_time + (video_time - state.video_time);
  if (state.move && since < state.move->length) {
    const scene::CameraPath& from = state.move->from;
    const double before = state.move->from_time + since;
    const Camera first = camera_from({from.azimuth + from.orbit * before, from.elevation});
    camera_from_frame =
        turned(first.camera_from_space(), camera_from_frame, state.move->share(since));
  }
  return camera_from_frame * frame_at(state, video_time, sample).transpose();
}

Camera BodyView::in_space(const Camera& camera, const timeline::FrameState& state) const {
  return carried(camera, frame_at(state, state.video_time, state.solutions[solution_].sample));
}

/// Returns the state with its trail and its blurred poses as seen in the frame, which has turned
/// since.
timeline::SolutionState BodyView::relative(const timeline::FrameState& state) const {
  timeline::SolutionState instant = state.solutions[solution_];
  if (frame_ == scene::Frame::space && !state.move) return instant;
  const Matrix3d now = frame_at(state, state.video_time, instant.sample);
  const auto carry = [&](motion::Sample& sample, double video_time) {
    sample.X = now * frame_at(state, video_time, sample).transpose() * sample.X;
  };
  for (motion::Sample& sample : instant.trail) {
    const double since = state.move ? state.move->time_of(sample.t, state.move_time) : 0;
    carry(sample, state.video_time + (since - state.move_time));
  }
  const auto poses = static_cast<double>(instant.blur.size());
  for (std::size_t i = 0; i < instant.blur.size(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / poses;
    carry(instant.blur[i], state.video_time + half_open_ * (2 * share - 1));
  }
  return instant;
}

/// Returns the turning of the camera while the shutter is open.
FixedStars::Turning BodyView::turning_in_shutter(const timeline::FrameState& state) const {
  constexpr int points = 5;
  const motion::Sample& now = state.solutions[solution_].sample;
  const motion::RotatingFrame frame = scene::reference_frame(frame_, motion_, now);
  FixedStars::Turning turning;
  for (int i = 0; i < points; ++i) {
    const double time = half_open_ * (2.0 * i / (points - 1) - 1);
    if (state.move && state.move->change && state.move_time < state.move->length) {
      motion::Sample then = now;
      then.t += time * speed_;
      turning.rotations.push_back(frame_at(state, state.video_time, now) *
                                  frame_at(state, state.video_time + time, then).transpose());
    } else {
      turning.rotations.push_back(so3::exp(-time * speed_ * (frame.attitude * frame.omega)));
    }
  }
  return turning;
}

FixedStars::Turning BodyView::turning(const timeline::FrameState& state,
                                      const Camera& camera) const {
  if (state.star_times.empty()) return turning_in_shutter(state);
  const Matrix3d space_from_camera = camera.camera_from_space().transpose();
  FixedStars::Turning turning{{}, true};
  for (std::size_t i = 0; i < state.star_times.size(); ++i) {
    const motion::Sample& then = state.solutions[solution_].stars[i];
    turning.rotations.push_back(space_from_camera *
                                camera_from_space(state, state.star_times[i], then));
  }
  return turning;
}

void BodyView::add_still(ViewContents& contents) const {
  if (!stars_ || turns_ || contents.is_moving) return;
  stars_->draw(contents.camera, {{Matrix3d::Identity()}}, contents.translucent);
}

void BodyView::add(const timeline::FrameState& state, ViewContents& contents) const {
  const timeline::SolutionState instant = relative(state);
  contents.X = instant.sample.X;
  for (const motion::Sample& sample : instant.blur) contents.blur.push_back(sample.X);
  if (stars_ && (turns_ || contents.is_moving)) {
    stars_->draw(contents.camera, turning(state, contents.camera), contents.translucent);
  }
  overlay_.draw(instant, contents.opaque, contents.translucent);
  if (forces_) forces_->draw(instant, contents.opaque);
  if (torques_) {
    torques_->draw(instant.sample, contents.camera, pane().area, contents.opaque,
                   contents.translucent);
  }
  if (tip_) tip_->draw(instant, contents.opaque, contents.translucent);
  if (!pane().named) return;
  contents.labels = overlay_.labels(state.solutions[solution_], contents.camera, pane().area);
  if (torques_) {
    std::ranges::move(torques_->labels(instant.sample, contents.camera, pane().area),
                      std::back_inserter(contents.labels));
  }
}

}  // namespace twrench::picture
