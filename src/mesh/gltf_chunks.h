#pragma once

#include <optional>
#include <string_view>

#include "mesh/source.h"

namespace twrench::mesh {

/// What a glTF file consists of.
struct GltfChunks {
  std::string_view json;
  /// The first buffer of a .glb file, where it has one.
  std::optional<std::string_view> binary;
};

/// Returns the chunks of a .glb file, or a .gltf file as the one that it is. Throws
/// system::FileError where a chunk is cut off.
GltfChunks gltf_chunks(const Source& source);

}  // namespace twrench::mesh
