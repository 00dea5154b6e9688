#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

namespace twrench::body {

/// A solid cylinder with its axis along z in its own frame. Lengths in cm.
struct Cylinder {
  /// Radius in cm.
  double radius;
  /// Length in cm.
  double length;
};

/// A solid box with edge lengths along x, y and z in cm.
struct Box {
  /// Edge lengths in cm.
  Eigen::Vector3d size;
};

/// A solid ellipsoid (a sphere if all are equal) with semi-axes along x, y and z in cm.
struct Ellipsoid {
  /// Semi-axes in cm.
  Eigen::Vector3d radii;
};

/// The geometry of a solid.
using Shape = std::variant<Cylinder, Box, Ellipsoid>;

/// A homogeneous solid, placed in the frame in which the scene describes the body.
struct Part {
  /// Geometry of the solid in its own frame.
  Shape shape;
  /// Density in g/cm^3.
  double density;
  /// Position of the centre in cm.
  Eigen::Vector3d position;
  /// Orientation, a proper rotation.
  Eigen::Matrix3d body_from_part;
};

/// Returns the volume in cm^3.
double volume(const Shape& shape);

/// Returns the moments of inertia in g cm^2 about the centre, in the shape's own frame, for `mass`
/// grams distributed homogeneously: the integrals of eq. (13), which are diagonal for these shapes.
Eigen::Vector3d central_moments(const Shape& shape, double mass);

/// Returns the bounding radius in cm: that of the smallest sphere about the shape's centre which
/// contains it.
double bounding_radius(const Shape& shape);

/// Returns a proper rotation whose third column is `axis` (of any nonzero length); exact for the
/// coordinate axes. Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (2017).
Eigen::Matrix3d frame_with_z_along(const Eigen::Vector3d& axis);

}  // namespace twrench::body
