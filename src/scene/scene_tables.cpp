#include "scene/scene_tables.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include "base/enumeration.h"
#include "scene/fields.h"
#include "scene/interior.h"
#include "scene/limits.h"
#include "scene/part_tables.h"

namespace twrench::scene {
namespace {

/// Reads the inertia matrix from whichever of its two keys [body] has.
Eigen::Matrix3d read_inertia(TomlTable& table) {
  if (const auto matrix = table.matrix("inertia")) {
    if (!table.has("moments")) return limits::check_inertia(table.place("inertia"), *matrix);
    throw InvalidArgument(table.place("inertia"), "moments give the inertia already",
                          "leave out one of them");
  }
  if (!table.has("moments")) {
    throw InvalidArgument(table.place(""), "has neither moments nor inertia", "give one of them");
  }
  const Eigen::Vector3d moments = table.required_vector("moments", limits::moment);
  return limits::check_inertia(table.place("moments"), moments.asDiagonal());
}

}  // namespace

Body read_body(TomlTable& file, MeshFiles& meshes) {
  Body body;
  file.tables("part", [&](TomlTable& part) {
    if (body.parts.size() == limits::max_parts) {
      throw InvalidArgument(part.place("shape"),
                            fmt::format("a body has at most {} parts", limits::max_parts));
    }
    read_part(part, meshes, body);
  });
  file.table("body", [&](TomlTable& table) {
    body.inertia = read_inertia(table);
    if (table.has("shape")) {
      body.drawn_as =
          find_enumerator<Equimomental>(table.required_text("shape"), table.place("shape"));
    }
  });
  if (body.parts.empty() && !body.inertia) {
    throw InvalidArgument(file.place("part"),
                          "the body must be given by [[part]] tables, by the moments or inertia of "
                          "[body], or by both");
  }
  if (!body.inertia)
    limits::check_moments(file.place("part"), body::mass_properties(body.parts).moments);
  return body;
}

void read_fields(TomlTable& file, const std::string& name, Scene& scene) {
  for (const Field& field : fields()) {
    if (field.table != name) continue;
    const auto value = file.value(field.key, field.form.kind);
    if (value) field.set(scene, *value, file.place(field.key));
  }
}

void require_interior(const TomlTable& table, const Scene& scene) {
  check_interior(scene, [&](const std::string& key) { return table.place("motion", key); });
}

}  // namespace twrench::scene
