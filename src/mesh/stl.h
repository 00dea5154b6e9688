#pragma once

#include "mesh/source.h"

namespace twrench::mesh {

/// Whether these are the bytes of a binary STL file, to the last: many of them begin with the word
/// "solid" as text files do.
bool is_binary_stl(std::string_view bytes);

/// Reads the triangles of an STL file, binary or text, each with three vertices of its own; normals
/// and attributes are passed over. Throws system::FileError where the file is damaged, and
/// InvalidArgument where a coordinate is not finite.
Content read_stl(const Source& source);

}  // namespace twrench::mesh
