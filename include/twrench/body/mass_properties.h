#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <array>
#include <span>

namespace twrench::body {

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

/// Returns the combined mass, centre of mass and inertia of the parts, by the parallel-axis
/// theorem. Throws InvalidArgument about "parts" if there are none or if they are so large that
/// their inertia overflows, and about "body_from_part" unless it is a rotation; OutOfRange about a
/// density or a length that is not positive, or a position that is not finite.
MassProperties mass_properties(std::span<const Part> parts);

/// Returns the inertia matrix in g cm^2 about a point in cm, in the frame in which the parts are
/// placed, by the parallel-axis theorem. NaN if the mass is NaN, which means that it is not known.
Eigen::Matrix3d inertia_about(const MassProperties& body, const Eigen::Vector3d& point);

/// The principal moments and axes of an inertia matrix.
struct PrincipalAxes {
  /// An axis, named after its moment. Its value is the index into `moments` and the columns of
  /// `axes`.
  enum Axis : int { least, intermediate, greatest };
  /// All axes in this order.
  static constexpr std::array all{least, intermediate, greatest};

  Eigen::Vector3d moments;  ///< Moments in g cm^2, ascending.
  Eigen::Matrix3d axes;     ///< Rotation body_from_principal; its columns are the axes.
};

/// Returns the principal moments, ascending, and axes of a symmetric `inertia` in g cm^2. The axes
/// form a proper rotation with a deterministic choice of sign: in each of the first two, the
/// component of largest magnitude (the first one on a tie) is positive. The axes of a diagonal
/// matrix are exactly a signed permutation. Throws InvalidArgument about "inertia" unless it is
/// finite and, to round-off, symmetric.
PrincipalAxes principal_axes(const Eigen::Matrix3d& inertia);

// Bodies of density 1 g/cm^3 with a given inertia matrix in g cm^2, aligned with its principal
// axes. They are drawn for a body that is given by its inertia alone. If the moments violate the
// triangle inequality, so that no real body has them, the result is nearly flat. Each function
// throws OutOfRange about a moment that is not positive, and InvalidArgument as principal_axes()
// does.

/// A box.
Part equimomental_box(const Eigen::Matrix3d& inertia);

/// An ellipsoid.
Part equimomental_ellipsoid(const Eigen::Matrix3d& inertia);

/// Terence Tao's discs (mathoverflow.net/a/82020): a flat cross with two heavy discs on the axis of
/// least moment and two lighter ones on the axis of intermediate moment. The two arms and the hub
/// come first, then the heavy discs, then the light ones.
std::array<Part, 7> equimomental_cross(const Eigen::Matrix3d& inertia);

/// A point mass.
struct PointMass {
  double mass;               ///< Mass in g.
  Eigen::Vector3d position;  ///< Position in cm.
};

/// Returns six point masses with the same mass, centre of mass and inertia as a part. Forces that
/// are linear in the position therefore have the same sum and the same torque on the points as on
/// the part. The points lie in pairs on the part's principal axes, each with a sixth of the mass.
/// For a box they are the centres of its faces; for a cylinder's z axis, the centres of its ends.
/// Throws as mass_properties() does.
std::array<PointMass, 6> equimomental_points(const Part& part);

}  // namespace twrench::body
