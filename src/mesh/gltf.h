#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Reads the triangles of the scene in a glTF 2.0 file, text or binary, in metres, with the nodes'
/// transforms applied and with the colours of the vertices. Of a material, only the base colour
/// factor is used; textures, skins, morph targets and animations are ignored. Buffers may only be
/// in the file itself or in files beside it. Throws system::FileError if the file is damaged, and
/// InvalidArgument if it requires an unsupported feature.
Content read_gltf(const Source& source);

}  // namespace twrench::mesh
