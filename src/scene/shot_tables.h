#pragma once

#include "scene/mesh_files.h"
#include "scene/scene.h"
#include "scene/toml_table.h"

namespace twrench::scene {

/// Reads the [[shot]] tables of a scene file into `film`, whose other values are complete. Throws
/// InvalidArgument, naming the shot and the line, for invalid shots, and FileError if a mesh cannot
/// be read.
void read_shots(TomlTable& file, Scene& film, MeshFiles& meshes);

}  // namespace twrench::scene
