#include "mesh/assembly.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <Eigen/LU>
#include <algorithm>
#include <cstdint>
#include <utility>

namespace twrench::mesh {
namespace {

constexpr std::size_t most_nodes = 1'000'000;
constexpr std::size_t most_repeated = 3'000'000;

}  // namespace

// Without repetition, a triangle takes at least one byte.
Assembly::Assembly(std::string name, std::size_t bytes)
    : name_(std::move(name)), most_(std::max(bytes, most_repeated)) {}

void Assembly::enter_node(std::size_t depth) {
  if (depth > most_nested) {
    throw InvalidArgument(name_, fmt::format("its nodes are nested more than {} deep", most_nested),
                          "remove nodes that contain themselves");
  }
  if (++nodes_ > most_nodes) {
    throw InvalidArgument(name_,
                          fmt::format("its nodes are repeated more than {} times", most_nodes),
                          "remove repeated nodes");
  }
}

void Assembly::add(const body::TriangleMesh& part, const Eigen::Affine3d& transform) {
  if (mesh_.triangles.size() + part.triangles.size() > most_ ||
      mesh_.vertices.size() + part.vertices.size() > 3 * most_) {
    throw InvalidArgument(name_,
                          fmt::format("its nodes repeat its meshes to more than {} triangles, or "
                                      "{} vertices",
                                      most_, 3 * most_),
                          "remove repeated nodes");
  }
  const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
  for (const Eigen::Vector3d& vertex : part.vertices) {
    mesh_.vertices.emplace_back(transform * vertex);
    if (!mesh_.vertices.back().allFinite()) {
      throw InvalidArgument(name_, "a node makes a coordinate infinite", "check its transform");
    }
  }
  const bool is_mirrored = transform.linear().determinant() < 0.0;
  for (auto [a, b, c] : part.triangles) {
    if (is_mirrored) std::swap(b, c);
    mesh_.triangles.push_back({first + a, first + b, first + c});
  }
}

}  // namespace twrench::mesh
