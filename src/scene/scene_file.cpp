// Scenes from TOML. Keys, units and defaults are documented in docs/scene-files.md.
#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/base/nearest.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

#include "embedded/scenes.h"
#include "scene/fields.h"
#include "scene/scene.h"
#include "scene/toml_table.h"
#include "system/file.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;

body::Shape read_shape(TomlTable& part) {
  const std::string shape = part.required_text("shape");
  if (shape == "cylinder") {
    return body::Cylinder{part.required_number("radius", limits::length),
                          part.required_number("length", limits::length)};
  }
  if (shape == "box") return body::Box{part.required_vector("size", limits::length)};
  if (shape == "ellipsoid") return body::Ellipsoid{part.required_vector("radii", limits::length)};
  if (shape == "sphere") {
    return body::Ellipsoid{Vector3d::Constant(part.required_number("radius", limits::length))};
  }
  const std::vector<std::string> shapes{"cylinder", "box", "ellipsoid", "sphere"};
  throw unknown_name(part.place("shape"), shape, shapes);
}

Eigen::Matrix3d read_orientation(TomlTable& part) {
  const Vector3d axis = part.vector("axis", limits::coordinate, Vector3d::UnitZ());
  const Vector3d rotation = part.vector("rotation", limits::coordinate, Vector3d::Zero());
  if (part.has("axis") && part.has("rotation")) {
    throw InvalidArgument(part.place("rotation"), "cannot be combined with axis");
  }
  if (axis.isZero(0.0)) throw InvalidArgument(part.place("axis"), "must not be zero");
  return part.has("axis") ? body::frame_with_z_along(axis) : so3::exp(rotation);
}

body::Part read_part(TomlTable& table) {
  body::Part part{read_shape(table), table.required_number("density", limits::density),
                  Vector3d::Zero(), read_orientation(table)};
  part.position = table.vector("position", limits::coordinate, Vector3d::Zero());
  return part;
}

Body read_body(TomlTable& file) {
  Body body;
  file.tables("part", [&](TomlTable& part) {
    if (body.parts.size() == limits::max_parts) {
      throw InvalidArgument(part.place("shape"),
                            fmt::format("a body has at most {} parts", limits::max_parts));
    }
    body.parts.push_back(read_part(part));
  });
  file.table("body", [&](TomlTable& table) {
    body.moments = limits::check_moments(table.place("moments"),
                                         table.required_vector("moments", limits::moment));
  });
  if (body.parts.empty() != body.moments.has_value()) {
    throw InvalidArgument(file.place("part"),
                          "the body must be given by either [[part]] tables or [body] moments");
  }
  if (!body.moments)
    limits::check_moments(file.place("part"), body::mass_properties(body.parts).moments);
  return body;
}

void read_fields(TomlTable& file, const std::string& name, Scene& scene) {
  for (const Field& field : fields()) {
    if (field.table != name) continue;
    const auto value = file.value(field.key, field.kind);
    if (value) field.set(scene, *value, file.place(field.key));
  }
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
    throw InvalidArgument(fmt::format("{}:{}", source, error.source().begin.line),
                          std::string(error.description()));
  }
  Scene scene;
  scene.name = std::filesystem::path(source).stem().string();
  TomlTable file(root, source, "");
  read_fields(file, "", scene);
  scene.body = read_body(file);
  for (const std::string& name : field_tables()) {
    file.table(name, [&](TomlTable& table) { read_fields(table, name, scene); });
  }
  file.finish();
  return scene;
}

std::vector<std::string> builtin_scene_names() {
  return {"dzhanibekov", "calm", "stable-y", "stable-z", "sphere", "tao-disk"};
}

Scene load_scene(const std::string& name_or_path) {
  if (is_path(name_or_path)) {
    constexpr std::size_t largest = 1 << 20;
    const std::vector<std::uint8_t> bytes = system::read_file(name_or_path, largest);
    return parse_scene(std::string(bytes.begin(), bytes.end()), name_or_path);
  }
  const std::string file = name_or_path + ".toml";
  const auto& builtin = embedded::scenes();
  if (!builtin.contains(file)) {
    throw unknown_name("scene", name_or_path, builtin_scene_names());
  }
  return parse_scene(builtin.at(file), file);
}

}  // namespace twrench::scene
