#pragma once

#include "scene/mesh_files.h"
#include "scene/scene.h"
#include "scene/toml_table.h"

namespace twrench::scene {

/// Reads a [[part]] table and adds the part to the body. Throws InvalidArgument and FileError.
void read_part(TomlTable& table, MeshFiles& meshes, Body& body);

}  // namespace twrench::scene
