#pragma once

#include <twrench/body/triangle_mesh.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <string>

namespace twrench::mesh {

/// Elements of a file that refer to others, such as nodes, may be nested this deep, because they
/// are visited recursively.
inline constexpr std::size_t most_nested = 1000;

/// The surface that the nodes of a file make of its meshes, each repeated any number of times. The
/// work is bounded, whatever the file says.
class Assembly {
 public:
  /// `name` is that of the file in messages, and `bytes` its size, unpacked.
  Assembly(std::string name, std::size_t bytes);

  /// Counts a node. Throws InvalidArgument if it is nested too deeply, or if there are too many.
  void enter_node(std::size_t depth);

  /// Adds a mesh as a node places it; a mirroring transform turns the triangles over. Throws
  /// InvalidArgument if a coordinate becomes infinite, or if there are too many triangles or
  /// vertices.
  void add(const body::TriangleMesh& part, const Eigen::Affine3d& transform);

  body::TriangleMesh& mesh() { return mesh_; }

 private:
  std::string name_;
  std::size_t most_;
  std::size_t nodes_ = 0;
  body::TriangleMesh mesh_;
};

}  // namespace twrench::mesh
