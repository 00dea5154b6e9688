#pragma once

#include <string>

#include "scene/mesh_files.h"
#include "scene/scene.h"
#include "scene/toml_table.h"

// The tables that a scene file has and each of its shots may have.
namespace twrench::scene {

/// Reads the [[part]] tables or [body] in `table`. Throws InvalidArgument unless there is either,
/// and FileError where a mesh cannot be read.
Body read_body(TomlTable& table, MeshFiles& meshes);

/// Sets the fields of the table with that name, empty for the top level, to those that `table` has.
void read_fields(TomlTable& table, const std::string& name, Scene& scene);

}  // namespace twrench::scene
