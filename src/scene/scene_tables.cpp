#include "scene/scene_tables.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/base/nearest.h>
#include <twrench/math/so3.h>

#include "scene/fields.h"
#include "scene/limits.h"

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

}  // namespace

Body read_body(TomlTable& file) {
  Body body;
  file.tables("part", [&](TomlTable& part) {
    if (body.parts.size() == limits::max_parts) {
      throw InvalidArgument(part.place("shape"),
                            fmt::format("a body has at most {} parts", limits::max_parts));
    }
    const auto name = part.value("name", Field::Kind::text);
    body.descriptions.push_back({name ? name->get<std::string>() : "", {}, {}});
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

}  // namespace twrench::scene
