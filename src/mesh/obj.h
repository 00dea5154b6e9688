#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Reads the vertices, with their colours, and the faces of a Wavefront OBJ file; everything else,
/// including materials, is ignored. Throws system::FileError about a line that is not OBJ, and
/// InvalidArgument about a line with invalid numbers.
Content read_obj(const Source& source);

}  // namespace twrench::mesh
