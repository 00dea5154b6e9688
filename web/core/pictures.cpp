// The functions that give pictures.js the contents of the page's views: the film's views of a
// motion at any time, seen by a camera that the user turns.

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/enumeration.h"
#include "page_views.h"
#include "picture/look/sky.h"
#include "scratch.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using picture::ViewContents;
using picture::Viewpoint;

Settings read_settings(Arguments& arguments) {
  Settings settings;
  for (const auto& [name, field] : fields) settings.*field = arguments.number();
  return settings;
}

Settings settings_alone() {
  Arguments arguments;
  return read_settings(arguments);
}

/// Reads motions at one time, each with its trail, oldest first: the number of samples, all times,
/// all X, and all omega.
timeline::FrameState read_state(Arguments& arguments) {
  timeline::FrameState state;
  state.solutions.resize(arguments.count());
  for (timeline::SolutionState& instant : state.solutions) {
    instant.trail.resize(arguments.count());
    for (motion::Sample& sample : instant.trail) sample.t = arguments.number();
    for (motion::Sample& sample : instant.trail) sample.X = arguments.matrix();
    for (motion::Sample& sample : instant.trail) sample.omega = arguments.vector();
    instant.sample = instant.trail.back();
  }
  return state;
}

template <typename Values>
void write_span(Results& results, const Values& values) {
  results << static_cast<const void*>(values.data()) << static_cast<double>(values.size());
}

void write_list(Results& results, const picture::DrawList& list) {
  write_span(results, list.vertices());
  for (const picture::DrawList::Triangles* triangles :
       {&list.items(), &list.outlines(), &list.ghosts()}) {
    write_span(results, triangles->faces);
    write_span(results, triangles->edge_quads);
  }
}

/// Returns the point at which a ray through a place of the picture, -1 to 1 across and up, meets
/// the unit sphere about the origin; a point on its silhouette if the ray misses it.
Vector3d on_sphere(const picture::Camera& camera, double x, double y) {
  const Eigen::Matrix4d& p = camera.projection;
  const Vector3d in_camera((x + p(0, 2)) / p(0, 0), (y + p(1, 2)) / p(1, 1), -1);
  const Vector3d ray = (camera.camera_from_space().transpose() * in_camera).normalized();
  const Vector3d eye = camera.distance * camera.camera_from_space().row(2).transpose();
  const double along = -eye.dot(ray);
  const double aside = std::max(eye.squaredNorm() - along * along, 0.0);
  return (eye + (along - std::sqrt(std::clamp(1 - aside, 0.0, 1.0))) * ray).normalized();
}

/// Writes the omega of a momentum of the same length in another direction, given in the picture's
/// coordinates.
void write_omega(const Motion& motion, const picture::MomentumView& view, const Vector3d& place) {
  const Vector3d momentum =
      motion.body.momentum().stableNorm() * (view.view_from_body().transpose() * place);
  Results(3) << Vector3d(
      motion.body.inertia().ldlt().solve(momentum - motion.body.interior().wheel));
}

void write_camera(Results& results, const picture::Camera& camera) {
  results << camera.camera_from_space() << camera.distance << camera.projection;
}

/// Writes the addresses of the contents in memory.
void write_contents(const ViewContents& contents) {
  Results results(64);
  write_camera(results, contents.camera);
  results << contents.opaque.clip_z_nearer(1);
  write_list(results, contents.opaque);
  write_list(results, contents.translucent);
  results << static_cast<double>(contents.labels.size());
  for (const picture::Label& label : contents.labels) {
    results << label.anchor.x() << label.anchor.y() << label.away.x() << label.away.y()
            << label.color.red << label.color.green << label.color.blue
            << static_cast<const void*>(label.text.c_str());
  }
}

}  // namespace
}  // namespace twrench::page

extern "C" {

using namespace twrench;
using namespace twrench::page;

/// The names of the settings and of their possible values, separated by blanks: lines of settings,
/// themes, frames, features, and the features that are insets.
[[clang::export_name("picture_names")]] const char* picture_names() {
  static std::string text;
  text.clear();
  for (const auto& [name, field] : fields) text += std::string(name) + " ";
  for (const std::vector<std::string>& names :
       {enumerator_names<scene::Theme>(), enumerator_names<scene::Frame>(),
        enumerator_names<scene::Feature>()}) {
    text += "\n";
    for (const std::string& name : names) text += name + " ";
  }
  text += "\n";
  for (const auto& [view, feature] : scene::insets) {
    text += std::string(enumerator_name(feature)) + " ";
  }
  return text.c_str();
}

/// Writes azimuth and elevation in rad of the direction from which an inset shows a motion best.
[[clang::export_name("inset_home")]] void inset_home(const Motion* motion, std::size_t inset) {
  const Viewpoint home = page::inset_home(*motion, settings_alone(), inset);
  Results(2) << home.azimuth << home.elevation;
}

[[clang::export_name("show_inset")]] void show_inset(const Motion* motion, std::size_t inset,
                                                     double azimuth, double elevation,
                                                     double zoom) {
  Arguments arguments;
  const Settings settings = read_settings(arguments);
  write_contents(
      inset_contents(*motion, settings, inset, {azimuth, elevation, zoom}, read_state(arguments)));
}

/// Writes the place of the start of the motion in the picture, in pixels.
[[clang::export_name("sphere_start")]] void sphere_start(const Motion* motion, double azimuth,
                                                         double elevation, double zoom) {
  const picture::MomentumView& view = sphere_view(*motion, settings_alone());
  const Eigen::Vector2d place = pixel_of(view.camera_from({azimuth, elevation, zoom}),
                                         view.pane().area, start_of(*motion, view));
  Results(2) << place.x() << place.y();
}

/// Writes the omega for a momentum that starts at a place in the picture, -1 to 1 across and up.
[[clang::export_name("sphere_omega_at")]] void sphere_omega_at(const Motion* motion, double azimuth,
                                                               double elevation, double zoom,
                                                               double x, double y) {
  const picture::MomentumView& view = sphere_view(*motion, settings_alone());
  write_omega(*motion, view, on_sphere(view.camera_from({azimuth, elevation, zoom}), x, y));
}

/// Writes the omega for a momentum whose start is moved by angles in rad.
[[clang::export_name("sphere_omega_moved")]] void sphere_omega_moved(const Motion* motion,
                                                                     double azimuth,
                                                                     double elevation, double zoom,
                                                                     double right, double up) {
  const picture::MomentumView& view = sphere_view(*motion, settings_alone());
  const Eigen::Matrix3d axes = view.camera_from({azimuth, elevation, zoom}).camera_from_space();
  const Vector3d moved = start_of(*motion, view) + axes.transpose() * Vector3d(right, up, 0);
  write_omega(*motion, view, moved.normalized());
}

[[clang::export_name("show_body")]] void show_body(const Motion* motion, double azimuth,
                                                   double elevation, double zoom) {
  Arguments arguments;
  const Settings settings = read_settings(arguments);
  write_contents(
      body_contents(*motion, settings, {azimuth, elevation, zoom}, read_state(arguments)));
}

/// Writes the stars of a theme, `count` of them in the picture of the default camera: direction in
/// space, brightness and tint of each.
[[clang::export_name("theme_stars")]] const float* theme_stars(int count) {
  static std::vector<float> stars;
  stars.clear();
  for (const auto& [direction, brightness, tint] : picture::sky(count)) {
    for (const double x : direction) stars.push_back(static_cast<float>(x));
    stars.push_back(static_cast<float>(brightness));
    stars.push_back(static_cast<float>(tint));
  }
  Results(1) << static_cast<double>(stars.size());
  return stars.data();
}

}  // extern "C"
