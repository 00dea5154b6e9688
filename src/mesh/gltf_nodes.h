#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/gltf_json.h"

namespace twrench::mesh {

/// A mesh of a glTF file where a node places it.
struct GltfInstance {
  std::uint64_t mesh;
  Eigen::Matrix4d transform;  ///< From the mesh to the scene.
};

/// Returns the meshes of the scene that is shown, or of all nodes where the file has no scene.
/// Throws system::FileError where the nodes are no forest.
std::vector<GltfInstance> gltf_instances(const GltfValue& document);

}  // namespace twrench::mesh
