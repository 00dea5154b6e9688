#pragma once

#include "scene/scene.h"
#include "scene/toml_table.h"

namespace twrench::scene {

/// Reads the [[shot]] tables of a scene file into `film`, whose other values are complete. Throws
/// InvalidArgument, naming the shot and the line, for shots that no film can be made of.
void read_shots(TomlTable& file, Scene& film);

}  // namespace twrench::scene
