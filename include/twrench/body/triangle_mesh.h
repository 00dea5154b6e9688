#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace twrench::body {

/// A surface of triangles.
struct TriangleMesh {
  /// Positions in cm.
  std::vector<Eigen::Vector3d> vertices;
  /// Three indices of vertices each, counter-clockwise as seen from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// sRGB colours of the vertices, each component 0 to 1; empty if the surface has none.
  std::vector<std::array<float, 3>> colors;
};

/// The integrals over a homogeneous solid of density 1 g/cm^3.
struct SolidIntegrals {
  /// Volume in cm^3.
  double volume = 0.0;
  /// Centre of mass in cm, in the frame of the vertices.
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /// Inertia matrix in g cm^2 about the centroid.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// Returns the integrals over the solid inside a closed surface by the divergence theorem, exact to
/// round-off. Throws InvalidArgument about "mesh" if there are no triangles, an index is out of
/// range, a coordinate is not finite, or the volume is not positive.
SolidIntegrals solid_integrals(const TriangleMesh& mesh);

/// Returns the integrals over a wall of `thickness` cm along a surface, open or closed, in the
/// limit of a thin wall: the surface integrals times the thickness. Throws OutOfRange about
/// "thickness" unless it is positive, and InvalidArgument about "mesh" as above or if the area is
/// 0.
SolidIntegrals shell_integrals(const TriangleMesh& mesh, double thickness);

/// Returns the area of the triangles in cm^2; 0 if there are none. Throws InvalidArgument about
/// "mesh" if an index is out of range or a coordinate is not finite.
double surface_area(const TriangleMesh& mesh);

}  // namespace twrench::body
