// What the views of the page show: those of the film, for a motion that is under way and a camera
// that is turned by hand. pictures.js hands over the settings and draws what is returned.

#include <twrench/motion/method.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "picture/views/body_view.h"
#include "picture/views/momentum_view.h"
#include "picture/views/poinsot_view.h"
#include "scratch.h"
#include "stars.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using picture::ViewContents;
using picture::Viewpoint;
using timeline::SolutionState;

/// What the page chooses of a picture beside the motion and the viewpoint.
struct Settings {
  double width = 1, height = 1;       ///< Of the pane in pixels.
  double thinnest = 1;                ///< Width in pixels of the thinnest line.
  double theme = 0, frame = 0;        ///< Indices of enumerators.
  double show = 0;                    ///< A bit for each feature.
  double azimuth = 0, elevation = 0;  ///< Of the camera for which things are framed, rad.
  double distance = 1;                ///< In units of the one at which things just fit.
  double field_of_view = 0.5;         ///< Of the view of the body, rad.
  double interval = 0;                ///< Seconds of motion in the time of one frame.
  double radius = 1;                  ///< Bounding radius of the body, cm.
  double trail_length = 1;            ///< s
  double trail_x = 0, trail_y = 0, trail_z = 0;  ///< What draws the trail, body axes, cm.
  double curve_begin = 0, curve_end = 1;         ///< Times of the herpolhode that is drawn, s.

  bool operator==(const Settings&) const = default;
};

/// The settings by their names in JavaScript.
constexpr std::array<std::pair<const char*, double Settings::*>, 18> fields{
    {{"width", &Settings::width},
     {"height", &Settings::height},
     {"thinnest", &Settings::thinnest},
     {"theme", &Settings::theme},
     {"frame", &Settings::frame},
     {"show", &Settings::show},
     {"azimuth", &Settings::azimuth},
     {"elevation", &Settings::elevation},
     {"distance", &Settings::distance},
     {"fieldOfView", &Settings::field_of_view},
     {"interval", &Settings::interval},
     {"radius", &Settings::radius},
     {"trailLength", &Settings::trail_length},
     {"trailX", &Settings::trail_x},
     {"trailY", &Settings::trail_y},
     {"trailZ", &Settings::trail_z},
     {"curveBegin", &Settings::curve_begin},
     {"curveEnd", &Settings::curve_end}}};

Settings read_settings(Arguments& arguments) {
  Settings settings;
  for (const auto& [name, field] : fields) settings.*field = arguments.number();
  return settings;
}

Settings settings_alone() {
  Arguments arguments;
  return read_settings(arguments);
}

/// Reads a motion at one time with its trail, oldest first: the number of samples, all times, all
/// X, and all omega.
SolutionState read_instant(Arguments& arguments) {
  SolutionState state;
  state.trail.resize(arguments.count());
  for (motion::Sample& sample : state.trail) sample.t = arguments.number();
  for (motion::Sample& sample : state.trail) sample.X = arguments.matrix();
  for (motion::Sample& sample : state.trail) sample.omega = arguments.vector();
  state.sample = state.trail.back();
  return state;
}

/// The scene that the film would have for these settings.
scene::Scene scene_of(const Settings& settings, const motion::FreeBody& body) {
  const auto chosen = [](const auto& enumerators, double index) {
    return enumerators.at(static_cast<std::size_t>(index));
  };
  scene::Scene scene;
  scene.body.inertia = body.inertia();
  scene.motion.omega = body.omega();
  scene.motion.duration = settings.curve_end - settings.curve_begin;
  scene.film.speed = settings.interval;
  scene.film.fps = 1;
  scene.look.theme = chosen(enumerators<scene::Theme>, settings.theme);
  scene.camera.frame = chosen(enumerators<scene::Frame>, settings.frame);
  scene.camera.azimuth = settings.azimuth;
  scene.camera.elevation = settings.elevation;
  scene.camera.distance = settings.distance;
  scene.camera.field_of_view = settings.field_of_view;
  scene.overlay.show.clear();
  const auto shown = static_cast<std::size_t>(settings.show);
  for (std::size_t i = 0; i < enumerators<scene::Feature>.size(); ++i) {
    if ((shown >> i & 1) != 0) scene.overlay.show.insert(enumerators<scene::Feature>[i]);
  }
  scene.overlay.trail_length = settings.trail_length;
  scene.overlay.trail_point = Vector3d(settings.trail_x, settings.trail_y, settings.trail_z);
  return scene;
}

/// The exact motion at these times, s.
std::vector<timeline::Solution> solution_of(const Motion& motion, std::span<const double> times) {
  return {{.method = &motion::find_method("exact"),
           .control = {},
           .body = motion.body,
           .initial_energy = motion.initial_energy,
           .whole = motion.exact.at(times, 1),
           .flips = std::nullopt,
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

/// A view, and what it was made for.
template <typename View>
class Kept {
 public:
  /// Returns the view, made anew by make(scene, pane) if the motion or a setting has changed.
  template <typename Make>
  View& get(const Motion& motion, const Settings& settings, Make make) {
    if (!view_ || serial_ != motion.serial || settings_ != settings) {
      view_.reset();  // gives its memory to the next
      view_ = make(scene_of(settings, motion.body), pane_of(settings));
      serial_ = motion.serial;
      settings_ = settings;
    }
    return *view_;
  }

 private:
  std::unique_ptr<View> view_;
  int serial_ = 0;
  Settings settings_;
};

Kept<picture::BodyView> body_pane;
Kept<picture::MomentumView> sphere;
Kept<picture::PoinsotView> poinsot;
ViewContents contents;

/// Both show all that they can.
scene::Scene with_all(scene::Scene scene) {
  scene.overlay.show.insert({scene::Feature::trail, scene::Feature::labels});
  return scene;
}

/// The times at which a camera that turns with a frame has the arrows in view.
std::vector<double> framed_times(const Motion& motion, double trail_length) {
  const auto flips = motion.exact.flips();
  const bool turns_over = flips && flips->swing >= std::numbers::pi / 2;
  const bool is_short = turns_over && std::isfinite(flips->interval);
  return evenly_spaced(0, is_short ? 2 * flips->interval : 8 * trail_length, 720);
}

picture::BodyView& body_view(const Motion& motion, const Settings& settings) {
  return body_pane.get(motion, settings, [&](const scene::Scene& scene, const auto& pane) {
    const auto times = framed_times(motion, settings.trail_length);
    return std::make_unique<picture::BodyView>(scene, solution_of(motion, times), 0, pane,
                                               settings.radius);
  });
}

picture::MomentumView& sphere_view(const Motion& motion, const Settings& settings) {
  return sphere.get(motion, settings, [&](const scene::Scene& scene, const auto& pane) {
    auto view =
        std::make_unique<picture::MomentumView>(with_all(scene), solution_of(motion, {}), 0, pane);
    if (std::isfinite(settings.azimuth)) view->set_home(settings.azimuth, settings.elevation);
    return view;
  });
}

picture::PoinsotView& poinsot_view(const Motion& motion, const Settings& settings) {
  return poinsot.get(motion, settings, [&](const scene::Scene& scene, const auto& pane) {
    const auto times = evenly_spaced(settings.curve_begin, settings.curve_end, 1200);
    return std::make_unique<picture::PoinsotView>(with_all(scene), solution_of(motion, times), 0,
                                                  pane);
  });
}

void write_home(const picture::View& view) {
  const Viewpoint home = view.viewpoint(0);
  Results(2) << home.azimuth << home.elevation;
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

/// Returns where the motion starts on the sphere.
Vector3d start_of(const Motion& motion, const picture::MomentumView& view) {
  return view.view_from_body() * motion.body.momentum().stableNormalized();
}

/// A ring around the start, by which it can be dragged.
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

/// Returns where a ray through a place of the picture, -1 to 1 across and up, meets the unit sphere
/// about the origin; on its silhouette where the ray misses it.
Vector3d on_sphere(const picture::Camera& camera, double x, double y) {
  const Eigen::Matrix4d& p = camera.projection;
  const Vector3d in_camera((x + p(0, 2)) / p(0, 0), (y + p(1, 2)) / p(1, 1), -1);
  const Vector3d ray = (camera.camera_from_space().transpose() * in_camera).normalized();
  const Vector3d eye = camera.distance * camera.camera_from_space().row(2).transpose();
  const double along = -eye.dot(ray);
  const double aside = std::max(eye.squaredNorm() - along * along, 0.0);
  return (eye + (along - std::sqrt(std::clamp(1 - aside, 0.0, 1.0))) * ray).normalized();
}

/// Writes the omega of the same momentum in another direction, given in the picture's coordinates.
void write_omega(const Motion& motion, const picture::MomentumView& view, const Vector3d& place) {
  const Vector3d momentum =
      motion.body.momentum().stableNorm() * (view.view_from_body().transpose() * place);
  Results(3) << Vector3d(motion.body.inertia().ldlt().solve(momentum));
}

void write_camera(Results& results, const picture::Camera& camera) {
  results << camera.camera_from_space() << camera.distance << camera.projection;
}

/// Writes where the contents lie in memory.
void write_contents() {
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

timeline::FrameState state_of(SolutionState instant) {
  timeline::FrameState state;
  state.solutions.push_back(std::move(instant));
  return state;
}

}  // namespace
}  // namespace twrench::page

extern "C" {

using namespace twrench;
using namespace twrench::page;

/// The names of the settings and of what they are chosen from: words separated by blanks, in lines
/// of settings, themes, frames and features.
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
  return text.c_str();
}

/// The direction, azimuth and elevation in rad, from which a motion is seen best.
[[clang::export_name("sphere_home")]] void sphere_home(const Motion* motion) {
  Settings settings = settings_alone();
  settings.azimuth = std::nan("");
  write_home(sphere_view(*motion, settings));
}

[[clang::export_name("poinsot_home")]] void poinsot_home(const Motion* motion) {
  write_home(poinsot_view(*motion, settings_alone()));
}

/// The momentum sphere with `paths` motions.
[[clang::export_name("show_sphere")]] void show_sphere(const Motion* motion, std::size_t paths,
                                                       double azimuth, double elevation,
                                                       double zoom) {
  Arguments arguments;
  const Settings settings = read_settings(arguments);
  const picture::MomentumView& view = sphere_view(*motion, settings);
  contents.begin(view.camera_from({azimuth, elevation, zoom}), view.pane().area);
  view.add_still(contents);
  view.add_axis_labels(contents);
  if (motion->body.momentum().isZero(0)) return write_contents();
  const picture::OverlayColors& colors =
      picture::style_of(scene_of(settings, motion->body).look.theme).overlay;
  std::vector<SolutionState> instants;
  for (std::size_t i = 0; i < paths; ++i) instants.push_back(read_instant(arguments));
  // The first is the one that counts, so it is drawn last.
  if (paths > 1) view.add_momentum(instants[1], "B", colors.omega, contents);
  view.add_momentum(instants[0], paths > 1 ? "A" : "L", colors.momentum, contents);
  add_handle(start_of(*motion, view), settings.thinnest, colors);
  write_contents();
}

/// Where the start of the motion is in the picture, in pixels.
[[clang::export_name("sphere_start")]] void sphere_start(const Motion* motion, double azimuth,
                                                         double elevation, double zoom) {
  const picture::MomentumView& view = sphere_view(*motion, settings_alone());
  const Eigen::Vector2d place = pixel_of(view.camera_from({azimuth, elevation, zoom}),
                                         view.pane().area, start_of(*motion, view));
  Results(2) << place.x() << place.y();
}

/// The omega with which the momentum starts at a place in the picture, -1 to 1 across and up.
[[clang::export_name("sphere_omega_at")]] void sphere_omega_at(const Motion* motion, double azimuth,
                                                               double elevation, double zoom,
                                                               double x, double y) {
  const picture::MomentumView& view = sphere_view(*motion, settings_alone());
  write_omega(*motion, view, on_sphere(view.camera_from({azimuth, elevation, zoom}), x, y));
}

/// The omega with which it starts that far from where it does, in rad.
[[clang::export_name("sphere_omega_moved")]] void sphere_omega_moved(const Motion* motion,
                                                                     double azimuth,
                                                                     double elevation, double zoom,
                                                                     double right, double up) {
  const picture::MomentumView& view = sphere_view(*motion, settings_alone());
  const Eigen::Matrix3d axes = view.camera_from({azimuth, elevation, zoom}).camera_from_space();
  const Vector3d moved = start_of(*motion, view) + axes.transpose() * Vector3d(right, up, 0);
  write_omega(*motion, view, moved.normalized());
}

[[clang::export_name("show_poinsot")]] void show_poinsot(const Motion* motion, double azimuth,
                                                         double elevation, double zoom) {
  Arguments arguments;
  const picture::PoinsotView& view = poinsot_view(*motion, read_settings(arguments));
  contents.begin(view.camera_from({azimuth, elevation, zoom}), view.pane().area);
  view.add(state_of(read_instant(arguments)), contents);
  write_contents();
}

/// The direction from which the scene's camera sees the body is a setting; the viewpoint adds to
/// it.
[[clang::export_name("show_body")]] void show_body(const Motion* motion, double azimuth,
                                                   double elevation, double zoom) {
  Arguments arguments;
  const picture::BodyView& view = body_view(*motion, read_settings(arguments));
  const timeline::FrameState state = state_of(read_instant(arguments));
  const picture::Camera own = view.camera_from({azimuth, elevation, zoom});
  contents.begin(view.in_space(own, state), view.pane().area);
  view.add(state, contents);
  write_contents();
}

/// The stars of a theme, `count` of them in the picture of the scene's own camera: of each the
/// direction in space, the brightness and the tint.
[[clang::export_name("theme_stars")]] const float* theme_stars(const Motion* motion, int count) {
  const picture::BodyView& view = body_view(*motion, settings_alone());
  static std::vector<float> stars;
  stars = stars_around(view.camera(0), count);
  Results(1) << static_cast<double>(stars.size());
  return stars.data();
}

}  // extern "C"
