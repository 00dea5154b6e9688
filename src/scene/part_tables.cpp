#include "scene/part_tables.h"

#include <twrench/base/error.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/words.h"
#include "scene/dimensions.h"
#include "scene/keys.h"
#include "scene/limits.h"
#include "scene/materials.h"
#include "system/error.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;

const Key& part_key(std::string_view name) { return key_named(part_keys(), name); }
const Key& mesh_key(std::string_view name) { return key_named(mesh_keys(), name); }

/// Reads a required number within the limits of its key.
double read_number(TomlTable& part, const Key& key) {
  return part.required_number(key.name, key.form.limit.value());
}

/// Returns the vector of a key, or its default.
Vector3d read_vector(TomlTable& part, const Key& key, const Vector3d& otherwise) {
  return part.vector(key.name, key.form.limit.value(), otherwise);
}

void require_no_contradiction(const TomlTable& part, const std::vector<Key>& keys) {
  for (const Key& key : keys) {
    if (key.instead_of.empty() || !part.has(key.name) || !part.has(key.instead_of)) continue;
    throw InvalidArgument(part.place(key.name), "cannot be combined with " + key.instead_of);
  }
}

body::Shape read_solid(TomlTable& part, body::Shape solid) {
  for (const body::Dimension& dimension : body::dimensions(solid)) {
    const limits::Limit& limit = limit_of(dimension);
    if (dimension.values.size() == 1) {
      const bool is_read = !dimension.may_be_zero || part.has(dimension.key);
      if (is_read) dimension.values[0] = part.required_number(dimension.key, limit);
    } else {
      std::ranges::copy(part.required_vector(dimension.key, limit), dimension.values.begin());
    }
  }
  return solid;
}

body::Shape read_sphere(TomlTable& part) {
  return body::Ellipsoid{Vector3d::Constant(part.required_number("radius", limits::length))};
}

/// Returns the centimetres per unit of the file; nothing if its format determines it.
std::optional<double> read_scale(TomlTable& part) {
  if (part.has("scale")) return read_number(part, mesh_key("scale"));
  if (!part.has("unit")) return std::nullopt;
  return mesh::unit_length(part.place("unit"), part.required_text("unit"));
}

/// Returns the path of the mesh. TOML can write a NUL, at which the system would end the path.
std::string read_path(TomlTable& part) {
  const std::string file = part.required_text("file");
  if (!file.empty() && file.find('\0') == std::string::npos) return file;
  throw InvalidArgument(part.place("file"), "is not the path of a file");
}

body::Shape read_mesh(TomlTable& part, MeshFiles& meshes, PartDescription& description) {
  require_no_contradiction(part, mesh_keys());
  const std::string file = read_path(part);
  mesh::ReadOptions options{.scale = read_scale(part)};
  if (part.has("shell")) options.shell = read_number(part, mesh_key("shell"));
  if (part.has("weld")) options.weld = read_number(part, mesh_key("weld"));
  if (part.has("crease")) description.look.crease_angle = read_number(part, mesh_key("crease"));
  try {
    const MeshEntry& entry = meshes.read(file, options);
    description.mesh = entry.source;
    description.notes = entry.notes;
    return entry.shape;
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(part.place("file"), error.what(), error.remedy());
  } catch (const system::FileError& error) {
    throw system::FileError(part.place("file"), error.what(), error.remedy());
  }
}

body::Shape read_shape(TomlTable& part, MeshFiles& meshes, PartDescription& description) {
  const std::string word = part.required_text("shape");
  if (word == "sphere") return read_sphere(part);
  const std::optional<body::Shape> shape = body::shape_named(word);
  if (!shape) throw unknown_name(part.place("shape"), word, part_key("shape").form.names);
  if (std::holds_alternative<body::Mesh>(*shape)) return read_mesh(part, meshes, description);
  return read_solid(part, *shape);
}

double read_density(TomlTable& part, const body::Shape& shape) {
  if (!part.has("mass")) return read_number(part, part_key("density"));
  return limits::density_of_mass(part.place("mass"), read_number(part, part_key("mass")),
                                 body::volume(shape));
}

Eigen::Matrix3d read_orientation(TomlTable& part) {
  const Vector3d axis = read_vector(part, part_key("axis"), Vector3d::UnitZ());
  const Vector3d rotation = read_vector(part, part_key("rotation"), Vector3d::Zero());
  if (axis.isZero(0.0)) throw InvalidArgument(part.place("axis"), "must not be zero");
  return part.has("axis") ? body::frame_with_z_along(axis) : so3::exp(rotation);
}

/// Reads the material, then the values that replace its own.
void read_look(TomlTable& part, PartLook& look) {
  if (part.has("material")) {
    set_material(look, find_material(part.required_text("material"), part.place("material")));
  }
  if (part.has("color")) look.color = parse_color(part.required_text("color"), part.place("color"));
  if (part.has("metallic")) look.metallic = read_number(part, part_key("metallic"));
  if (part.has("roughness")) look.roughness = read_number(part, part_key("roughness"));
}

}  // namespace

void read_part(TomlTable& table, MeshFiles& meshes, Body& body) {
  require_no_contradiction(table, part_keys());
  PartDescription description;
  if (table.has("name")) description.name = table.required_text("name");
  const body::Shape shape = read_shape(table, meshes, description);
  check_dimensions(shape, [&](const std::string& key) { return table.place(key); });
  const double density = read_density(table, shape);
  const Vector3d position = read_vector(table, part_key("position"), Vector3d::Zero());
  const Eigen::Matrix3d orientation = read_orientation(table);
  read_look(table, description.look);
  body.parts.push_back({shape, density, position, orientation});
  body.descriptions.push_back(std::move(description));
}

}  // namespace twrench::scene
