#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Reads the triangles of a glTF 2.0 file, text or binary, in metres: those of its scene, each node
/// placed by its transforms, with the colours of the vertices. Materials, textures, skins and
/// animations are passed over. Buffers may be in the file, or in files beside it, and nowhere else.
/// Throws system::FileError where the file is damaged, and InvalidArgument where it needs what is
/// not read.
Content read_gltf(const Source& source);

}  // namespace twrench::mesh
