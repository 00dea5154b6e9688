#pragma once

#include <Eigen/Core>
#include <span>

#include "body/shape.h"

namespace twrench {

/// The mass properties that determine a body's motion. The centre of mass is the origin of the body
/// frame.
struct MassProperties {
  /// Mass in g.
  double mass;
  /// Centre of mass in cm, in the frame in which the parts are placed, eq. (44).
  Eigen::Vector3d centre_of_mass;
  /// Inertia matrix in g cm^2 about the centre of mass, in body axes, eq. (13).
  Eigen::Matrix3d inertia;
  /// Principal moments in g cm^2, ascending.
  Eigen::Vector3d moments;
  /// Rotation body_from_principal: column i is the principal axis of moments[i].
  Eigen::Matrix3d axes;
};

/// Returns the mass, centre of mass and inertia of all parts together, by the parallel-axis
/// theorem. `parts` must not be empty, and every density and size must be positive.
MassProperties mass_properties(std::span<const Part> parts);

/// The principal moments, ascending, and principal axes of a symmetric inertia matrix. The axes
/// form a proper rotation whose signs are chosen deterministically: each of the first two has a
/// positive component of largest magnitude (the first of equal ones). A diagonal matrix gives an
/// exact signed permutation.
struct PrincipalAxes {
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;  ///< Rotation body_from_principal; its columns are the axes.
};
PrincipalAxes principal_axes(const Eigen::Matrix3d& inertia);

/// Returns the homogeneous box of density 1 g/cm^3 whose principal moments about x, y and z are
/// `moments`, in g cm^2. It is drawn where a body is given only by its moments. Moments that no
/// real body has (they violate the triangle inequality) give a box with one edge close to zero.
Part equimomental_box(const Eigen::Vector3d& moments);

}  // namespace twrench
