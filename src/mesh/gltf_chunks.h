#pragma once

#include <optional>
#include <string_view>

#include "mesh/source.h"

namespace twrench::mesh {

/// The chunks of a glTF file.
struct GltfChunks {
  std::string_view json;
  /// The first buffer of a .glb file, if it has one.
  std::optional<std::string_view> binary;
};

/// Returns the chunks of a .glb file; a .gltf file is a single JSON chunk. Throws system::FileError
/// if a chunk is cut off.
GltfChunks gltf_chunks(const Source& source);

}  // namespace twrench::mesh
