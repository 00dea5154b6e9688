#pragma once

#include <twrench/body/triangle_mesh.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twrench::mesh {

/// The triangles of a mesh in a binary tree of bounding boxes. Neighbours in space are neighbours
/// in the tree, which is complete: node n has the children 2n and 2n + 1, and 1 is the root.
class TriangleTree {
 public:
  /// A triangle and its box.
  struct Item {
    Eigen::AlignedBox3f box;
    std::uint32_t triangle;
  };

  /// The mesh must outlive the tree, and not change.
  explicit TriangleTree(const body::TriangleMesh& mesh);

  const body::TriangleMesh& mesh() const { return *mesh_; }
  bool is_leaf(std::size_t node) const { return node >= first_leaf_; }
  std::size_t first_leaf() const { return first_leaf_; }

  /// The box of a node, from the least corner of the whole mesh on. As rounding to single precision
  /// keeps the order of numbers, boxes meet if what is in them does.
  const Eigen::AlignedBox3f& box(std::size_t node) const { return boxes_[node]; }

  /// What is in a leaf.
  std::span<const Item> items(std::size_t leaf) const;

  /// The box of the whole mesh.
  const Eigen::AlignedBox3d& whole() const { return whole_; }

  /// The corner `k` of a triangle.
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
