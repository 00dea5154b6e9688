// Scenes from TOML. Keys, units and defaults are documented in docs/scene-files.md.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/nearest.h"
#include "embedded/scenes.h"
#include "math/so3.h"
#include "scene/names.h"
#include "scene/scene.h"
#include "scene/toml_table.h"

namespace twrench {
namespace {

using Eigen::Vector3d;

Shape read_shape(TomlTable& part) {
  const std::string shape = part.required_text("shape");
  if (shape == "cylinder") {
    return Cylinder{part.required_number("radius", limits::length),
                    part.required_number("length", limits::length)};
  }
  if (shape == "box") return Box{part.required_vector("size", limits::length)};
  if (shape == "ellipsoid") return Ellipsoid{part.required_vector("radii", limits::length)};
  if (shape == "sphere") {
    return Ellipsoid{Vector3d::Constant(part.required_number("radius", limits::length))};
  }
  const std::vector<std::string> shapes{"cylinder", "box", "ellipsoid", "sphere"};
  throw unknown_name(part.place("shape"), shape, shapes);
}

Eigen::Matrix3d read_orientation(TomlTable& part) {
  Vector3d axis = Vector3d::UnitZ();
  Vector3d rotation = Vector3d::Zero();
  part.vector("axis", limits::coordinate, axis);
  part.vector("rotation", limits::coordinate, rotation);
  if (part.has("axis") && part.has("rotation")) {
    throw UsageError(part.place("rotation"), "cannot be combined with axis");
  }
  if (axis.isZero(0.0)) throw UsageError(part.place("axis"), "must not be zero");
  return part.has("axis") ? frame_with_z_along(axis) : so3::exp(rotation);
}

Part read_part(TomlTable& table) {
  Part part{read_shape(table), table.required_number("density", limits::density), Vector3d::Zero(),
            read_orientation(table)};
  table.vector("position", limits::coordinate, part.position);
  return part;
}

Body read_body(TomlTable& file) {
  Body body;
  file.tables("part", [&](TomlTable& part) {
    if (body.parts.size() == limits::most_parts) {
      throw UsageError(part.place("shape"),
                       fmt::format("a body has at most {} parts", limits::most_parts));
    }
    body.parts.push_back(read_part(part));
  });
  file.table("body", [&](TomlTable& table) {
    body.moments = limits::check_moments(table.place("moments"),
                                         table.required_vector("moments", limits::moment));
  });
  if (body.parts.empty() != body.moments.has_value()) {
    throw UsageError(file.place("part"),
                     "the body must be given by either [[part]] tables or [body] moments");
  }
  if (!body.moments) limits::check_moments(file.place("part"), mass_properties(body.parts).moments);
  return body;
}

void read_motion(TomlTable& table, Motion& motion) {
  if (table.has("omega")) {
    motion.omega = limits::check_omega(table.place("omega"),
                                       table.required_vector("omega", limits::coordinate));
  }
  table.text("method", motion.method);
  find_method(motion.method, table.place("method"));
  table.number("step", limits::step, motion.control.step);
  table.number("tolerance", limits::tolerance, motion.control.tolerance);
  table.number("duration", limits::duration, motion.duration);
}

void read_film(TomlTable& table, Film& film) {
  table.size("size", limits::pixels, film.width, film.height);
  table.number("fps", limits::fps, film.fps);
  table.number("speed", limits::speed, film.speed);
}

void read_look(TomlTable& table, Look& look) {
  if (table.has("theme")) {
    look.theme = theme_of(table.required_text("theme"), table.place("theme"));
  }
  table.whole("samples", limits::samples, look.samples);
  table.whole("motion_blur", limits::motion_blur, look.motion_blur);
  if (table.has("background"))
    set_background(look, table.required_text("background"), table.place("background"));
  if (table.has("color")) {
    look.color = parse_color(table.required_text("color"), table.place("color"));
  }
  if (table.has("metallic")) look.metallic = table.required_number("metallic", limits::fraction);
  if (table.has("roughness")) {
    look.roughness = table.required_number("roughness", limits::roughness);
  }
}

void read_camera(TomlTable& table, CameraPath& camera) {
  table.number("azimuth", limits::angle, camera.azimuth);
  table.number("elevation", limits::elevation, camera.elevation);
  table.number("distance", limits::distance, camera.distance);
  table.number("orbit", limits::angle, camera.orbit);
  table.number("field_of_view", limits::angle_of_view, camera.field_of_view);
}

void read_overlay(TomlTable& table, Overlay& overlay) {
  if (table.has("view")) overlay.view = view_of(table.required_text("view"), table.place("view"));
  if (table.has("show")) {
    overlay.show.clear();
    for (const std::string& name : table.required_texts("show")) {
      overlay.show.insert(feature_of(name, table.place("show")));
    }
  }
  if (table.has("compare")) {
    overlay.compare = compared_methods(table.required_texts("compare"), table.place("compare"));
  }
  if (table.has("trail_point")) {
    overlay.trail_point = table.required_vector("trail_point", limits::coordinate);
  }
  if (table.has("trail_length")) {
    overlay.trail_length = table.required_number("trail_length", limits::trail_length);
  }
  table.text("font", overlay.font);
}

/// Whether this is a path: because of its extension (in upper or lower case), because it has a
/// folder, or because the file exists. No name of a built-in scene looks like one.
bool is_path(const std::string& name_or_path) {
  std::string ending = std::filesystem::path(name_or_path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  std::error_code none;
  const bool is_builtin = embedded::scenes().contains(name_or_path + ".toml");
  return ending == ".toml" || name_or_path.find('/') != std::string::npos ||
         (!is_builtin && std::filesystem::exists(name_or_path, none));
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& source) {
  toml::table root;
  try {
    root = toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    throw UsageError(fmt::format("{}:{}", source, error.source().begin.line),
                     std::string(error.description()));
  }
  Scene scene;
  scene.name = std::filesystem::path(source).stem().string();
  TomlTable file(root, source, "");
  file.text("title", scene.title);
  scene.body = read_body(file);
  file.table("motion", [&](TomlTable& table) { read_motion(table, scene.motion); });
  file.table("film", [&](TomlTable& table) { read_film(table, scene.film); });
  file.table("look", [&](TomlTable& table) { read_look(table, scene.look); });
  file.table("camera", [&](TomlTable& table) { read_camera(table, scene.camera); });
  file.table("overlay", [&](TomlTable& table) { read_overlay(table, scene.overlay); });
  file.finish();
  return scene;
}

std::vector<std::string> builtin_scene_names() {
  return {"dzhanibekov", "stable-y", "stable-z", "sphere"};
}

Scene load_scene(const std::string& name_or_path) {
  if (is_path(name_or_path)) {
    constexpr std::size_t largest = 1 << 20;
    const std::vector<std::uint8_t> bytes = read_file(name_or_path, largest);
    return parse_scene(std::string(bytes.begin(), bytes.end()), name_or_path);
  }
  const std::string file = name_or_path + ".toml";
  const auto& builtin = embedded::scenes();
  if (!builtin.contains(file)) {
    throw unknown_name("scene", name_or_path, builtin_scene_names());
  }
  return parse_scene(builtin.at(file), file);
}

}  // namespace twrench
