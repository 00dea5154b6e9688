#pragma once

#include <twrench/body/triangle_mesh.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twrench::mesh {

/// The triangles of a mesh in a complete binary tree of bounding boxes: node n has the children 2n
/// and 2n + 1, and 1 is the root. Neighbours in space are close in the tree.
class TriangleTree {
 public:
  /// A triangle and its box.
  struct Item {
    Eigen::AlignedBox3f box;
    std::uint32_t triangle;
  };

  /// The mesh must outlive the tree and must not change.
  explicit TriangleTree(const body::TriangleMesh& mesh);

  const body::TriangleMesh& mesh() const { return *mesh_; }
  bool is_leaf(std::size_t node) const { return node >= first_leaf_; }
  std::size_t first_leaf() const { return first_leaf_; }

  /// Returns the box of a node, relative to the least corner of the whole mesh. Rounding to single
  /// precision preserves the order of numbers, so boxes intersect if their contents do.
  const Eigen::AlignedBox3f& box(std::size_t node) const { return boxes_[node]; }

  /// Returns the items of a leaf.
  std::span<const Item> items(std::size_t leaf) const;

  /// Returns the box of the whole mesh.
  const Eigen::AlignedBox3d& whole() const { return whole_; }

  /// Returns corner `k` of a triangle.
  const Eigen::Vector3d& corner(std::uint32_t triangle, std::size_t k) const {
    return mesh_->vertices[mesh_->triangles[triangle][k]];
  }

 private:
  Eigen::AlignedBox3f rounded_box(std::uint32_t triangle) const;

  const body::TriangleMesh* mesh_;
  Eigen::AlignedBox3d whole_;
  std::vector<Item> items_;
  std::size_t first_leaf_ = 1;
  std::vector<Eigen::AlignedBox3f> boxes_;
};

}  // namespace twrench::mesh
