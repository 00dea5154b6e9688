#include "mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace twrench::mesh {
namespace {

using Eigen::AlignedBox3f;

constexpr std::size_t leaf_size = 4;
constexpr std::size_t grain = 1 << 15;

/// Orders items so that a plane across the longest axis of the box of their centres separates the
/// centres of the first `half` from the others.
void split(std::span<TriangleTree::Item> items, std::size_t half) {
  AlignedBox3f centres;
  for (const TriangleTree::Item& item : items) centres.extend(item.box.center());
  Eigen::Index axis = 0;
  centres.sizes().maxCoeff(&axis);
  const auto key = [axis](const TriangleTree::Item& item) {
    return std::pair(item.box.min()[axis] + item.box.max()[axis], item.triangle);
  };
  std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(half), {}, key);
}

}  // namespace

TriangleTree::TriangleTree(const body::TriangleMesh& mesh) : mesh_(&mesh) {
  for (const Eigen::Vector3d& vertex : mesh.vertices) whole_.extend(vertex);
  const std::size_t count = mesh.triangles.size();
  items_.resize(count);
  for_each_part(count, grain, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto triangle = static_cast<std::uint32_t>(i);
      items_[i] = {rounded_box(triangle), triangle};
    }
  });
  first_leaf_ = std::bit_ceil((count + leaf_size - 1) / leaf_size);
  boxes_.resize(2 * first_leaf_);
  // Level by level. Leaves are filled from the first on, so the range of each node is known.
  for (std::size_t size = first_leaf_ * leaf_size; size > leaf_size; size /= 2) {
    const std::size_t half = size / 2, nodes = (count + half - 1) / size;
    for_each_part(nodes, std::max<std::size_t>(grain / size, 1), 0,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t at = begin * size; at < end * size; at += size) {
                      split(std::span(items_).subspan(at, std::min(size, count - at)), half);
                    }
                  });
  }
  for (std::size_t leaf = first_leaf_; leaf < 2 * first_leaf_; ++leaf) {
    for (const Item& item : items(leaf)) boxes_[leaf].extend(item.box);
  }
  for (std::size_t node = first_leaf_ - 1; node > 0; --node) {
    boxes_[node] = boxes_[2 * node].merged(boxes_[2 * node + 1]);
  }
}

AlignedBox3f TriangleTree::rounded_box(std::uint32_t triangle) const {
  AlignedBox3f box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.extend((corner(triangle, k) - whole_.min()).cast<float>());
  }
  return box;
}

std::span<const TriangleTree::Item> TriangleTree::items(std::size_t leaf) const {
  const std::size_t begin = std::min((leaf - first_leaf_) * leaf_size, items_.size());
  return std::span(items_).subspan(begin, std::min(leaf_size, items_.size() - begin));
}

}  // namespace twrench::mesh
