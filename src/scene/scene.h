#pragma once

#include <Eigen/Core>
#include <optional>
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

/// What is drawn beside the geometry of the body.
struct Look {
  int samples = 4;                         ///< of the multisampled framebuffer; 1 is none
  bool bare = false;                       ///< the body alone
  bool transparent = false;                ///< no background: alpha is the body's coverage
  std::optional<Color> background;         ///< a flat one; else the graded one
  Color color{184, 188, 196};              ///< of the metal
  double metallic = 1.0;                   ///< 0 to 1
  double roughness = 0.34;                 ///< 0.05 to 1
  double field_of_view = 0.55;             ///< the smaller angle of the view, rad
  Eigen::Vector3d camera{0.0, 5.0, 20.0};  ///< direction from the body to the camera, space axes
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

  /// N = round(duration * fps / speed). Throws UsageError unless that is 1 to 10^7.
  int frame_count() const;
};

/// Of the scene's body. Where it is given by its moments alone, mass is NaN and the centre 0.
MassProperties mass_properties(const Body& body);

/// The parts to draw, centred on the centre of mass: the body's own, or the equimomental box.
std::vector<Part> visible_parts(const Body& body);

/// The names of the scenes that are built in.
std::vector<std::string> builtin_scene_names();

/// The built-in scene of that name or, when `name_or_path` ends in ".toml", that file's.
/// Throws UsageError for an unknown name (with the nearest offered) or a bad scene (with file, line
/// and key), FileError where the file cannot be read.
Scene load_scene(const std::string& name_or_path);

/// Reads a scene from TOML text; `source` names it in errors.
Scene parse_scene(std::string_view toml, const std::string& source);

}  // namespace twrench
