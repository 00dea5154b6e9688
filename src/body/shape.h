#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

namespace twrench {

/// A solid cylinder; its axis is z in its own frame. Lengths in cm.
struct Cylinder {
  double radius;
  double length;
};

/// A solid box. Edge lengths along x, y, z in cm.
struct Box {
  Eigen::Vector3d size;
};

/// A solid ellipsoid (a sphere where all are equal). Semi-axes along x, y, z in cm.
struct Ellipsoid {
  Eigen::Vector3d radii;
};

using Shape = std::variant<Cylinder, Box, Ellipsoid>;

/// A homogeneous solid, placed in the frame in which the scene describes the body.
struct Part {
  Shape shape;
  double density;                  ///< g/cm^3
  Eigen::Vector3d position;        ///< of its centre, cm
  Eigen::Matrix3d body_from_part;  ///< orientation; proper orthogonal
};

/// Volume in cm^3.
double volume(const Shape& shape);

/// Inertia in g cm^2 about the centre, in the shape's own frame, of `mass` grams spread evenly:
/// the integrals of eq. (13), which are diagonal for these shapes.
Eigen::Vector3d central_moments(const Shape& shape, double mass);

/// Radius in cm of the smallest sphere about the shape's centre that holds it.
double bounding_radius(const Shape& shape);

/// The proper rotation whose third column is `axis` (any nonzero length), exact for coordinate
/// axes. Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (2017).
Eigen::Matrix3d frame_with_z_along(const Eigen::Vector3d& axis);

}  // namespace twrench
