#pragma once

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "body/mass_properties.h"
#include "body/shape.h"
#include "motion/trajectory.h"
#include "scene/color.h"

namespace twrench {

/// The body: its parts or, where it is given so, its principal moments alone.
struct Body {
  std::vector<Part> parts;
  std::optional<Eigen::Vector3d>
      moments;  ///< about the body's x, y, z, g cm^2; then parts is empty
};

struct Motion {
  Eigen::Vector3d omega{1.0, 0.05, 0.0};  ///< omega(0), body axes, rad/s
  std::string method = "rkmk45";
  StepControl control;
  double duration = 96.0;  ///< s of motion
};

struct Film {
  int width = 1920, height = 1080;  ///< pixels
  double fps = 60.0;                ///< frames per second of film
  double speed = 6.0;               ///< seconds of motion per second of film

  /// t of frame i: i * speed / fps, never accumulated.
  double time_of(int frame) const { return frame * speed / fps; }
};

/// The whole of a picture's finish: material, lights, background, colours of what is laid over.
enum class Theme { studio, paper, space };

struct Look {
  Theme theme = Theme::studio;
  int samples = 1;                  ///< a pixel; with 1, edges are smoothed one by one instead
  int motion_blur = 1;              ///< poses that a frame is the mean of; 1 is none
  bool transparent = false;         ///< no background: alpha is the coverage of what is drawn
  std::optional<Color> background;  ///< a flat one; else the theme's
  std::optional<Color> color;       ///< of the body; else the theme's
  std::optional<double> metallic;   ///< 0 to 1; else the theme's
  std::optional<double> roughness;  ///< 0.05 to 1; else the theme's
};

/// A camera that looks at the centre of mass. Angles in rad.
struct CameraPath {
  double azimuth = 0.0;         ///< from space's z axis towards x
  double elevation = 0.245;     ///< above the plane of x and z
  double distance = 1.0;        ///< 1 is where the body, in every pose, just fits its place
  double orbit = 0.0;           ///< rad per second of film, about space's y axis
  double field_of_view = 0.55;  ///< the smaller angle of the view
};

/// What can be shown beside the body.
enum class Feature {
  floor,       ///< with the body's shadow and reflection
  axes,        ///< of the body
  momentum,    ///< L, an arrow
  omega,       ///< another
  trail,       ///< of a point of the body, and of omega's in the views of the momentum
  plane,       ///< the invariable plane
  labels,      ///< names of the arrows and axes
  hud,         ///< title, time, method, drift, flips
  components,  ///< the nine of X against time
  sphere,      ///< the momentum sphere, an inset
  poinsot,     ///< Poinsot's construction, an inset
};

enum class View { wrench, momentum, poinsot, quad };

/// What explains the motion.
struct Overlay {
  View view = View::wrench;
  std::set<Feature> show{Feature::floor,  Feature::momentum, Feature::omega,      Feature::trail,
                         Feature::labels, Feature::hud,      Feature::components, Feature::sphere};
  std::vector<std::string> compare;            ///< methods, side by side; empty: the motion's alone
  std::optional<Eigen::Vector3d> trail_point;  ///< cm, in the axes of the parts; else the farthest
  std::optional<double> trail_length;          ///< s of motion; else 12 rad's worth
  std::string font = "sans";                   ///< of those that are built in, or a file

  bool shows(Feature feature) const { return show.contains(feature); }
};

/// Sets the background from "transparent" or a colour. Throws UsageError about `what`.
void set_background(Look& look, const std::string& text, const std::string& what);

/// Everything that determines a film. Plain values with defaults; a file or the command line
/// overrides them.
struct Scene {
  std::string name;  ///< names the output; letters, digits, '-' and '_'
  std::string title;
  Body body;
  Motion motion;
  Film film;
  Look look;
  CameraPath camera;
  Overlay overlay;

  /// N = round(duration * fps / speed). Throws UsageError unless that is 1 to 10^7.
  int frame_count() const;
};

/// Of the scene's body. Where it is given by its moments alone, mass is NaN and the centre 0.
MassProperties mass_properties(const Body& body);

/// The parts to draw, centred on the centre of mass: the body's own, or the equimomental box.
std::vector<Part> visible_parts(const Body& body);

/// The names of the scenes that are built in.
std::vector<std::string> builtin_scene_names();

/// The built-in scene of that name or, when `name_or_path` ends in ".toml", in any case, has a
/// folder, or is there and no built-in name, that file's.
/// Throws UsageError for an unknown name (with the nearest offered) or a bad scene (with file, line
/// and key), FileError where the file cannot be read.
Scene load_scene(const std::string& name_or_path);

/// Reads a scene from TOML text; `source` names it in errors.
Scene parse_scene(std::string_view toml, const std::string& source);

}  // namespace twrench
