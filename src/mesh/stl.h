#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Returns whether the bytes are exactly a binary STL file. The size decides, because many binary
/// files begin with "solid" as text files do.
bool is_binary_stl(std::string_view bytes);

/// Reads the triangles of an STL file, binary or text. No two triangles share a vertex. Normals and
/// the two bytes of attributes are ignored; longer attributes and bytes after the last triangle are
/// ignored with a note. Throws system::FileError if the file is damaged, and InvalidArgument if
/// a coordinate is not finite.
Content read_stl(const Source& source);

}  // namespace twrench::mesh
