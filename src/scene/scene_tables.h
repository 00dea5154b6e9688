#pragma once

#include <string>

#include "scene/mesh_files.h"
#include "scene/scene.h"
#include "scene/toml_table.h"

// The tables that a scene file and each of its shots may have.
namespace twrench::scene {

/// Reads the [[part]] tables or [body] in `table`. Throws InvalidArgument unless there is exactly
/// one of them, and FileError if a mesh cannot be read.
Body read_body(TomlTable& table, MeshFiles& meshes);

/// Sets the fields of the table with that name (empty for the top level) to the values in `table`.
void read_fields(TomlTable& table, const std::string& name, Scene& scene);

/// Throws InvalidArgument, with the place of the key in `table`, unless check_interior() allows the
/// scene.
void require_interior(const TomlTable& table, const Scene& scene);

}  // namespace twrench::scene
