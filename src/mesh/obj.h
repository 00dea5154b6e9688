#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Reads the vertices, with their colours, and the faces of a Wavefront OBJ file; everything else,
/// materials among it, is passed over. Throws system::FileError about a line that is not OBJ, and
/// InvalidArgument about one whose numbers cannot be.
Content read_obj(const Source& source);

}  // namespace twrench::mesh
