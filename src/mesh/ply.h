#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Reads the vertices, with their colours, and the faces of a PLY file, text or binary in either
/// byte order; other elements and properties are ignored, and bytes after the last element with a
/// note. Throws system::FileError if the file is damaged, and InvalidArgument if its numbers are
/// invalid.
Content read_ply(const Source& source);

}  // namespace twrench::mesh
