#include "page/stills.h"

#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "base/enumeration.h"
#include "embedded/article.h"
#include "page/figure_start.h"
#include "picture/look/theme.h"
#include "scene/interior.h"
#include "scene/natural_times.h"
#include "scene/shown_recording.h"

namespace twrench::page {
namespace {

using body::PrincipalAxes;
using Eigen::Vector3d;
using nlohmann::json;
using scene::Feature;
using scene::Scene;

// The size of a still in pixels: each pane consists of whole blocks of JPEG, and is too small for
// the legend of the forces.
constexpr int width = 192, height = 144;
constexpr double zoom_of_several = 0.88;  // as in web/article/figure.js

/// The body and the camera of the scene alone, for a picture of a figure.
Scene plain(const Scene& shown, int panes) {
  Scene scene = shown;
  scene.shots.clear();
  scene.film.width = width / panes;
  scene.film.height = height;
  scene.look.samples = 4;
  scene.camera.orbit = 0;
  scene.camera.frame = scene::Frame::space;
  scene.motion.recording = nullptr;
  scene.overlay = {};
  scene.overlay.show.clear();
  scene.overlay.trail_point = shown.overlay.trail_point;
  scene.overlay.trail_length = shown.overlay.trail_length;
  return scene;
}

/// Sets the times during which everything must be in view of a camera that turns with a frame: two
/// intervals between flips, or eight trails (web/core/page_views.cpp).
void set_framed_times(Scene& scene) {
  constexpr double radians_of_trail = 12;
  const motion::FreeBody body = scene::free_body(scene);
  const auto flips = body.is_rigid() ? motion::ExactMotion(body).flips() : std::nullopt;
  if (scene.camera.frame == scene::Frame::space) {
    scene.motion.duration = scene::natural_times(body).step;
  } else if (flips && flips->turns_over() && std::isfinite(flips->interval)) {
    scene.motion.duration = 2 * flips->interval;
  } else {
    scene.motion.duration =
        8 * scene.overlay.trail_length.value_or(radians_of_trail / body.fastest_rate());
  }
}

/// The box of three different moments that replaces a body in the figures.
Scene with_box(Scene scene) {
  const Vector3d moments(700, 1000, 1500);  // g cm^2, as in web/article/body.js
  scene.body = {};
  scene.body.inertia = moments.asDiagonal();
  scene.overlay.trail_point.reset();
  return scene;
}

/// A motion that a figure shows.
struct Start {
  Vector3d omega;
  std::optional<Vector3d> wheel = {};
  std::optional<Eigen::Quaterniond> attitude = {};
  std::shared_ptr<const scene::ShownRecording> recording = nullptr;
};

std::vector<Start> starts_of(const json& figure, const FigureStart& start) {
  const std::string control = figure.at("control");
  const double push = figure.value("push", 0.0), value = figure.value("value", push);
  const double angle = value * std::numbers::pi / 180;
  if (control == "axis") return {{start.between(angle)}};
  if (control == "lean") return {{start.leaning(angle)}};
  const bool is_pushed = control == "push" || control == "delay";
  std::vector<Start> starts;
  for (const std::string axis : figure.at("spin")) {
    const auto index = axis == "least"    ? PrincipalAxes::least
                       : axis == "middle" ? PrincipalAxes::intermediate
                                          : PrincipalAxes::greatest;
    starts.push_back({start.spun(index, is_pushed ? value : push)});
  }
  if (control == "wheel") starts.front().wheel = start.wheel(value);
  if (figure.contains("compare")) starts.push_back(starts.front());
  return starts;
}

/// The motion of the scene, after the recorded one if they are compared.
std::vector<Start> starts_of_scene(const json& figure, const scene::Motion& motion) {
  const Start computed{motion.omega, motion.wheel, motion.attitude};
  if (!figure.contains("compare")) return {computed};
  Start recorded = computed;
  recorded.recording = motion.recording;
  return {recorded, computed};
}

/// The scene of the body view of a figure, without its motion.
Scene figure_scene(const json& figure, const Scene& shown, int panes) {
  Scene scene = plain(shown, panes);
  for (const std::string name : figure.at("show")) {
    const auto feature = find_enumerator<Feature>(name, "show");
    if (feature != Feature::labels) scene.overlay.show.insert(feature);
  }
  scene.camera.frame = find_enumerator<scene::Frame>(figure.value("frame", "space"), "frame");
  if (figure.at("spin").size() > 1) scene.camera.distance /= zoom_of_several;
  return scene;
}

Scene moved(Scene scene, const Start& start) {
  scene.motion.omega = start.omega;
  scene.motion.wheel = start.wheel;
  scene.motion.energy_loss_time.reset();
  scene.motion.attitude = start.attitude;
  set_framed_times(scene);
  scene.motion.recording = start.recording;
  if (start.recording) {
    scene.motion.duration = std::min(scene.motion.duration, start.recording->motion.duration());
  }
  return scene;
}

/// The scene as an inset, on the colour of its panel.
Scene inset(Scene scene, scene::View view) {
  scene.overlay.view = view;
  scene.overlay.show = {Feature::momentum, Feature::trail};
  scene.look.background = picture::style_of(scene.look.theme).overlay.panel;
  return scene;
}

void add_figure(const json& section, const Scene& shown, const FigureStart& start,
                std::vector<Still>& stills) {
  const json& figure = section.at("figure");
  const std::string name = "part-" + section.at("id").get<std::string>();
  const std::vector<Start> starts =
      section.contains("when") ? starts_of_scene(figure, shown.motion) : starts_of(figure, start);
  const bool has_sphere = figure.value("sphere", false);
  const Scene scene =
      figure_scene(figure, shown, static_cast<int>(starts.size()) + (has_sphere ? 1 : 0));
  Still& still = stills.emplace_back(Still{name, {}});
  for (const Start& each : starts) still.panes.push_back(moved(scene, each));
  if (has_sphere) still.panes.push_back(inset(still.panes.front(), scene::View::momentum));
}

void add_article(const Scene& shown, std::vector<Still>& stills) {
  const FigureStart own(scene::mass_properties(shown.body).inertia, shown.motion.omega);
  const bool is_replaced = own.has_equal_moments();
  const Scene with_figures_body = is_replaced ? with_box(shown) : shown;
  const FigureStart start = is_replaced ? own.of_body(*with_figures_body.body.inertia) : own;
  for (const json& section : json::parse(embedded::article().at("article.json"))) {
    const std::string when = section.value("when", "");
    if (when.empty()) {
      add_figure(section, with_figures_body, start, stills);
    } else if (when == "replaced" ? is_replaced : shown.motion.recording != nullptr) {
      add_figure(section, shown, own, stills);
    }
  }
}

}  // namespace

std::vector<Still> stills_of(const Scene& shown, bool has_article) {
  std::vector<Still> stills;
  if (has_article) add_article(shown, stills);
  const std::span of_rigid = scene::features_of_rigid_bodies;
  for (const auto& [view, feature] : scene::insets) {
    if (!shown.motion.is_rigid() && std::ranges::find(of_rigid, feature) != of_rigid.end())
      continue;
    stills.push_back({std::string(enumerator_name(feature)), {inset(plain(shown, 1), view)}});
  }
  return stills;
}

}  // namespace twrench::page
