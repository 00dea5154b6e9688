#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/gltf_json.h"

namespace twrench::mesh {

/// A mesh of a glTF file as placed by a node.
struct GltfInstance {
  std::uint64_t mesh;
  Eigen::Matrix4d transform;  ///< From the mesh to the scene.
  /// Whether the node repeats the mesh by the extension EXT_mesh_gpu_instancing, which is not read.
  bool is_repeated;
};

/// Returns the mesh instances of the default scene, or of all nodes if the file has no scene.
/// Throws system::FileError if the nodes do not form a forest.
std::vector<GltfInstance> gltf_instances(const GltfValue& document);

}  // namespace twrench::mesh
