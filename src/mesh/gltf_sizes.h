#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "mesh/gltf_buffers.h"
#include "mesh/gltf_json.h"
#include "mesh/gltf_nodes.h"

namespace twrench::mesh {

/// The kinds of primitives that consist of triangles, with glTF's numbers.
enum class GltfMode : std::uint64_t { triangles = 4, strip = 5, fan = 6 };

/// A primitive that has triangles.
struct GltfPrimitive {
  GltfValue value;
  GltfMode mode;
};

/// The primitives of a glTF mesh and their counts.
struct GltfMesh {
  std::vector<GltfPrimitive> primitives;
  std::uint64_t vertices = 0, triangles = 0;
  std::uint64_t points_and_lines = 0;  ///< Primitives that are omitted.
  bool has_targets = false;
};

/// Returns the contents of the meshes that the instances use, by index, without building the
/// meshes. A file can repeat a mesh any number of times. Throws system::FileError if a mesh is
/// damaged, and InvalidArgument if the instances together have far more triangles than the file has
/// bytes.
std::map<std::uint64_t, GltfMesh> gltf_meshes(const Source& source, const GltfValue& document,
                                              const std::vector<GltfInstance>& instances,
                                              GltfBuffers& buffers);

}  // namespace twrench::mesh
