#include "scene/part_tables.h"

#include <twrench/base/error.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/nearest.h"
#include "scene/dimensions.h"
#include "scene/fields.h"
#include "scene/limits.h"
#include "scene/materials.h"
#include "system/error.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;

void read_dimension(TomlTable& part, const std::string& key, double& value,
                    const limits::Limit& limit) {
  if (limit.low > 0 || part.has(key)) value = part.required_number(key, limit);
}

body::Shape read_solid(TomlTable& part, body::Shape solid) {
  for (const body::Dimension& dimension : body::dimensions(solid)) {
    const limits::Limit& limit = limit_of(dimension);
    if (dimension.values.size() == 1) {
      read_dimension(part, dimension.key, dimension.values[0], limit);
    } else {
      std::ranges::copy(part.required_vector(dimension.key, limit), dimension.values.begin());
    }
  }
  return solid;
}

body::Shape read_sphere(TomlTable& part) {
  return body::Ellipsoid{Vector3d::Constant(part.required_number("radius", limits::length))};
}

/// Returns the centimetres per unit of the file; nothing where its format says it.
std::optional<double> read_scale(TomlTable& part) {
  if (part.has("scale") && part.has("unit")) {
    throw InvalidArgument(part.place("scale"), "cannot be combined with unit");
  }
  if (part.has("scale")) return part.required_number("scale", limits::mesh_scale);
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
  const std::string file = read_path(part);
  mesh::ReadOptions options{.scale = read_scale(part)};
  if (part.has("shell")) options.shell = part.required_number("shell", limits::length);
  read_dimension(part, "weld", options.weld, limits::length_or_none);
  read_dimension(part, "crease", description.look.crease_angle, limits::crease);
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

/// Returns the names of the shapes that a part can have.
std::vector<std::string> shape_words() {
  std::vector<std::string> words;
  for (const body::Shape& shape : body::all_shapes()) {
    words.push_back(body::shape_name(shape));
    if (std::holds_alternative<body::Ellipsoid>(shape)) words.emplace_back("sphere");
  }
  return words;
}

body::Shape read_shape(TomlTable& part, MeshFiles& meshes, PartDescription& description) {
  const std::string word = part.required_text("shape");
  if (word == "sphere") return read_sphere(part);
  const std::optional<body::Shape> shape = body::shape_named(word);
  if (!shape) throw unknown_name(part.place("shape"), word, shape_words());
  if (std::holds_alternative<body::Mesh>(*shape)) return read_mesh(part, meshes, description);
  return read_solid(part, *shape);
}

double read_density(TomlTable& part, const body::Shape& shape) {
  if (!part.has("mass")) return part.required_number("density", limits::density);
  if (part.has("density")) {
    throw InvalidArgument(part.place("mass"), "cannot be combined with density");
  }
  return limits::density_of_mass(part.place("mass"), part.required_number("mass", limits::mass),
                                 body::volume(shape));
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

/// Reads the material, then what differs from it.
void read_look(TomlTable& part, PartLook& look) {
  if (part.has("material")) {
    set_material(look, find_material(part.required_text("material"), part.place("material")));
  }
  if (part.has("color")) look.color = parse_color(part.required_text("color"), part.place("color"));
  if (part.has("metallic")) look.metallic = part.required_number("metallic", limits::fraction);
  if (part.has("roughness")) look.roughness = part.required_number("roughness", limits::roughness);
}

}  // namespace

void read_part(TomlTable& table, MeshFiles& meshes, Body& body) {
  PartDescription description;
  if (table.has("name")) description.name = table.required_text("name");
  const body::Shape shape = read_shape(table, meshes, description);
  check_dimensions(shape, [&](const std::string& key) { return table.place(key); });
  const double density = read_density(table, shape);
  const Vector3d position = table.vector("position", limits::coordinate, Vector3d::Zero());
  const Eigen::Matrix3d orientation = read_orientation(table);
  read_look(table, description.look);
  body.parts.push_back({shape, density, position, orientation});
  body.descriptions.push_back(std::move(description));
}

}  // namespace twrench::scene
