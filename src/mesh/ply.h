#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Reads the vertices, with their colours, and the faces of a PLY file, text or binary in either
/// byte order; other elements and properties are passed over. Throws system::FileError where the
/// file is damaged, and InvalidArgument where its numbers cannot be.
Content read_ply(const Source& source);

}  // namespace twrench::mesh
