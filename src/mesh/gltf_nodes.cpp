#include "mesh/gltf_nodes.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <utility>

namespace twrench::mesh {
namespace {

using Eigen::Matrix4d;

/// Returns the transform of a node in its parent's frame.
Matrix4d transform_of(const GltfValue& node) {
  if (const auto matrix = node.find("matrix")) {
    const std::vector<double> columns = matrix->numbers(16);
    return Eigen::Map<const Matrix4d>(columns.data());
  }
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (const auto translation = node.find("translation")) {
    const std::vector<double> t = translation->numbers(3);
    transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  }
  if (const auto rotation = node.find("rotation")) {
    const std::vector<double> q = rotation->numbers(4);
    transform.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
  }
  if (const auto scale = node.find("scale")) {
    const std::vector<double> s = scale->numbers(3);
    transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  }
  return transform.matrix();
}

std::vector<std::uint64_t> indices(const std::optional<GltfValue>& list) {
  std::vector<std::uint64_t> all;
  for (std::size_t i = 0; list && i < list->size(); ++i) all.push_back(list->at(i).whole());
  return all;
}

/// Returns the indices of the root nodes.
std::vector<std::uint64_t> roots(const GltfValue& document) {
  if (document.size("scenes") > 0) {
    return indices(document.at("scenes").at(document.whole_or("scene", 0)).find("nodes"));
  }
  const std::size_t count = document.size("nodes");
  std::vector<bool> is_child(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::uint64_t child : indices(document.at("nodes").at(i).find("children"))) {
      if (child < count) is_child[child] = true;
    }
  }
  std::vector<std::uint64_t> top;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_child[i]) top.push_back(i);
  }
  return top;
}

}  // namespace

std::vector<GltfInstance> gltf_instances(const GltfValue& document) {
  std::vector<GltfInstance> instances;
  std::vector<bool> visited(document.size("nodes"));
  std::vector<std::pair<std::uint64_t, Matrix4d>> open;
  for (const std::uint64_t root : roots(document)) open.emplace_back(root, Matrix4d::Identity());
  while (!open.empty()) {
    const auto [index, parent] = open.back();
    open.pop_back();
    const GltfValue node = document.at("nodes").at(index);
    if (visited[index]) throw node.bad("is a child of more than one node");
    visited[index] = true;
    const Matrix4d transform = parent * transform_of(node);
    if (const auto mesh = node.find("mesh")) {
      const auto extensions = node.find("extensions");
      const bool is_repeated = extensions && extensions->find("EXT_mesh_gpu_instancing");
      instances.push_back({mesh->whole(), transform, is_repeated});
    }
    for (const std::uint64_t child : indices(node.find("children"))) {
      open.emplace_back(child, transform);
    }
  }
  return instances;
}

}  // namespace twrench::mesh
