#include "picture/views/body_view.h"

#include <algorithm>
#include <iterator>

#include "picture/body/bounding_radius.h"
#include "picture/compose/camera_path.h"
#include "timeline/reference_frame.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;

std::optional<ForceArrows> forces_of(const scene::Scene& scene, const timeline::Solution& solution,
                                     double radius) {
  if (!scene.overlay.shows(scene::Feature::forces)) return std::nullopt;
  return ForceArrows(scene, solution, radius);
}

std::optional<TorqueArcs> torques_of(const scene::Scene& scene, const timeline::Solution& solution,
                                     double radius) {
  if (!scene.overlay.shows(scene::Feature::torques)) return std::nullopt;
  return TorqueArcs(scene, solution, radius);
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
      forces_(forces_of(scene, solutions[solution], radius_)),
      torques_(torques_of(scene, solutions[solution], radius_)),
      path_(scene.camera),
      framing_(framing_of(scene, solutions[solution])) {
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

/// Adds the floor or its shadow alone or, for a camera that turns with its frame, the stars.
void BodyView::add_surroundings(const scene::Scene& scene) {
  const bool shows_floor = scene.overlay.shows(scene::Feature::floor) && !scene.look.transparent;
  if (frame_ != scene::Frame::space) {
    if (shows_floor) stars_.emplace(scene);
    return;
  }
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
  constexpr std::size_t stride = 12;  // of the samples, which are finer than needed here
  for (std::size_t i = 0; i < solution.whole.size(); i += stride) {
    const Matrix3d frame_from_space = frame_at(solution.whole[i]).attitude.transpose();
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

motion::RotatingFrame BodyView::frame_at(const motion::Sample& sample) const {
  return timeline::reference_frame(frame_, motion_, sample);
}

Camera BodyView::in_space(const Camera& camera, const timeline::FrameState& state) const {
  return carried(camera, frame_at(state.solutions[solution_].sample).attitude);
}

/// Returns the state with its trail and its blurred poses as seen in the frame, which has turned
/// since.
timeline::SolutionState BodyView::relative(timeline::SolutionState instant) const {
  if (frame_ == scene::Frame::space) return instant;
  const Matrix3d now = frame_at(instant.sample).attitude;
  const auto carry = [&](motion::Sample& sample) {
    sample.X = now * frame_at(sample).attitude.transpose() * sample.X;
  };
  std::ranges::for_each(instant.trail, carry);
  std::ranges::for_each(instant.blur, carry);
  return instant;
}

void BodyView::add(const timeline::FrameState& state, ViewContents& contents) const {
  const timeline::SolutionState instant = relative(state.solutions[solution_]);
  contents.X = instant.sample.X;
  for (const motion::Sample& sample : instant.blur) contents.blur.push_back(sample.X);
  if (stars_) {
    stars_->draw(frame_at(instant.sample), contents.camera, pane().area.height,
                 contents.translucent);
  }
  overlay_.draw(instant, contents.opaque, contents.translucent);
  if (forces_) forces_->draw(instant, contents.opaque);
  if (torques_) {
    torques_->draw(instant.sample, contents.camera, pane().area, contents.opaque,
                   contents.translucent);
  }
  if (!pane().named) return;
  contents.labels = overlay_.labels(state.solutions[solution_], contents.camera, pane().area);
  if (torques_) {
    std::ranges::move(torques_->labels(instant.sample, contents.camera, pane().area),
                      std::back_inserter(contents.labels));
  }
}

}  // namespace twrench::picture
