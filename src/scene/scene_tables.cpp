#include "scene/scene_tables.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include "scene/fields.h"
#include "scene/limits.h"
#include "scene/names.h"
#include "scene/part_tables.h"

namespace twrench::scene {
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
    body.moments = limits::check_moments(table.place("moments"),
                                         table.required_vector("moments", limits::moment));
    if (table.has("shape")) {
      body.drawn_as = equimomental_of(table.required_text("shape"), table.place("shape"));
    }
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
