#include "page_views.h"

#include <twrench/motion/method.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "picture/views/inset_views.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using picture::ViewContents;
using picture::Viewpoint;

constexpr std::size_t sphere = scene::inset_index(scene::View::momentum);

template <typename Enumeration>
Enumeration chosen(double index) {
  return enumerators<Enumeration>.at(static_cast<std::size_t>(index));
}

std::set<scene::Feature> features_of(double bits) {
  const auto chosen_bits = static_cast<std::size_t>(bits);
  std::set<scene::Feature> features;
  for (std::size_t i = 0; i < enumerators<scene::Feature>.size(); ++i) {
    if ((chosen_bits >> i & 1) != 0) features.insert(enumerators<scene::Feature>[i]);
  }
  return features;
}

/// The scene that the film would have for these settings.
scene::Scene scene_of(const Settings& settings, const motion::FreeBody& body) {
  scene::Scene scene;
  scene.body.inertia = body.inertia();
  scene.motion.omega = body.omega();
  scene.motion.duration = settings.curve_end - settings.curve_begin;
  scene.film.speed = 1;
  scene.film.fps = 1 / settings.interval;  // infinite while the motion is paused
  scene.look.theme = chosen<scene::Theme>(settings.theme);
  scene.camera.frame = chosen<scene::Frame>(settings.frame);
  scene.camera.azimuth = settings.azimuth;
  scene.camera.elevation = settings.elevation;
  scene.camera.distance = settings.distance;
  scene.camera.field_of_view = settings.field_of_view;
  scene.overlay.show = features_of(settings.show);
  scene.overlay.stress = features_of(settings.stress);
  scene.overlay.trail_length = settings.trail_length;
  scene.overlay.trail_point = Vector3d(settings.trail_x, settings.trail_y, settings.trail_z);
  return scene;
}

/// The motion at these times, s.
std::vector<timeline::Solution> solution_of(const Motion& motion, std::span<const double> times) {
  return {{.method = &motion::find_method(motion.exact ? "exact" : "taylor"),
           .control = {},
           .body = motion.body,
           .initial_energy = motion.initial_energy,
           .whole = motion.at(times),
           .flips = std::nullopt,
           .wheel_flips = {},
           .flip_times = {}}};
}

std::vector<double> evenly_spaced(double begin, double end, int intervals) {
  std::vector<double> times;
  for (int i = 0; i <= intervals; ++i) times.push_back(begin + (end - begin) * i / intervals);
  return times;
}

picture::Layout::Pane pane_of(const Settings& settings) {
  const image::Area area{0, 0, static_cast<int>(settings.width), static_cast<int>(settings.height)};
  return {.area = area, .focus = area, .thinnest = settings.thinnest};
}

/// A value, and the motion and settings for which it was made.
template <typename Value>
class Cached {
 public:
  /// Returns the value. If the motion or a setting has changed, make() creates it again.
  template <typename Make>
  Value& get(const Motion& motion, const Settings& settings, Make make) {
    if (!value_ || serial_ != motion.serial || settings_ != settings) {
      value_.reset();  // frees its memory for the next one
      value_ = make();
      serial_ = motion.serial;
      settings_ = settings;
    }
    return *value_;
  }

 private:
  std::unique_ptr<Value> value_;
  int serial_ = 0;
  Settings settings_;
};

Cached<picture::BodyView> body_pane;
std::array<Cached<picture::SolutionView>, scene::insets.size()> inset_panes;
Cached<std::vector<timeline::Solution>> inset_motion;  // for the curves of all insets
ViewContents contents;

/// An inset always shows its trail and labels.
std::unique_ptr<picture::SolutionView> make_inset(const Motion& motion, const Settings& settings,
                                                  std::size_t inset) {
  scene::Scene scene = scene_of(settings, motion.body);
  scene.overlay.show.insert({scene::Feature::trail, scene::Feature::labels});
  const auto& solutions = inset_motion.get(
      motion, {.curve_begin = settings.curve_begin, .curve_end = settings.curve_end}, [&] {
        const auto times = evenly_spaced(settings.curve_begin, settings.curve_end, 1200);
        return std::make_unique<std::vector<timeline::Solution>>(solution_of(motion, times));
      });
  return picture::inset_views[inset].make(scene, solutions, pane_of(settings));
}

/// The times at which the arrows must be in view of a camera that turns with a frame.
std::vector<double> framed_times(const Motion& motion, double trail_length) {
  const auto flips = motion.exact ? motion.exact->flips() : std::nullopt;
  const bool turns_over = flips && flips->turns_over();
  const bool is_short = turns_over && std::isfinite(flips->interval);
  const double end = is_short ? 2 * flips->interval : 8 * trail_length;
  return evenly_spaced(0, motion.exact ? end : std::min(end, motion.integrated->longest()), 720);
}

/// Adds a ring around the start. With it the user drags the start.
void add_handle(const Vector3d& start, double unit, const picture::OverlayColors& colors) {
  constexpr int points = 40;
  picture::DrawList& list = contents.translucent;
  const Vector3d normal = (list.eye() - start).normalized();
  const Vector3d right = Vector3d::UnitY().cross(normal).normalized();
  const Vector3d above = normal.cross(right);
  const double radius = 7.5 * unit / std::max(list.pixels(start), 1.0);
  const double opacity = 0.35 + 0.65 * picture::shown(start, start, list.eye());
  std::vector<picture::DrawList::Point> ring;
  for (const auto& [width, color] : {std::pair(4.2, colors.panel), {2.0, colors.text}}) {
    ring.clear();
    for (int i = 0; i <= points; ++i) {
      const double angle = 2 * std::numbers::pi * i / points;
      ring.push_back({start + radius * (std::cos(angle) * right + std::sin(angle) * above),
                      width * unit,
                      {color, opacity}});
    }
    list.line(ring);
  }
}

}  // namespace

picture::BodyView& body_view(const Motion& motion, const Settings& settings) {
  return body_pane.get(motion, settings, [&] {
    const auto times = framed_times(motion, settings.trail_length);
    return std::make_unique<picture::BodyView>(scene_of(settings, motion.body),
                                               solution_of(motion, times), 0, pane_of(settings),
                                               settings.radius);
  });
}

picture::SolutionView& inset_view(const Motion& motion, const Settings& settings,
                                  std::size_t inset) {
  return inset_panes.at(inset).get(motion, settings, [&] {
    auto view = make_inset(motion, settings, inset);
    view->set_home(settings.azimuth, settings.elevation);
    return view;
  });
}

picture::MomentumView& sphere_view(const Motion& motion, const Settings& settings) {
  return static_cast<picture::MomentumView&>(inset_view(motion, settings, sphere));
}

Viewpoint inset_home(const Motion& motion, const Settings& settings, std::size_t inset) {
  return make_inset(motion, settings, inset)->viewpoint(0);
}

/// Returns where the motion starts on the sphere.
Vector3d start_of(const Motion& motion, const picture::MomentumView& view) {
  return view.view_from_body() * motion.body.momentum().stableNormalized();
}

const ViewContents& body_contents(const Motion& motion, const Settings& settings,
                                  const Viewpoint& from, const timeline::FrameState& state) {
  const picture::BodyView& view = body_view(motion, settings);
  contents.begin(view.in_space(view.camera_from(from), state), view.pane().area);
  view.add(state, contents);
  return contents;
}

const ViewContents& inset_contents(const Motion& motion, const Settings& settings,
                                   std::size_t inset, const Viewpoint& from,
                                   const timeline::FrameState& state) {
  const picture::SolutionView& view = inset_view(motion, settings, inset);
  contents.begin(view.camera_from(from), view.pane().area);
  view.add_still(contents);
  view.add(state, contents);
  if (inset == sphere && !motion.body.momentum().isZero(0)) {
    add_handle(start_of(motion, sphere_view(motion, settings)), settings.thinnest,
               picture::style_of(chosen<scene::Theme>(settings.theme)).overlay);
  }
  return contents;
}

}  // namespace twrench::page
