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

/// Mass, centre of mass and inertia of the parts together, by the parallel-axis theorem. Throws
/// InvalidArgument about "parts" where there are none, or so large that their inertia overflows;
/// about "body_from_part" unless that is a rotation; and OutOfRange about a density or a length
/// that is not positive, or a position that is not finite.
MassProperties mass_properties(std::span<const Part> parts);

/// The principal moments and axes of an inertia matrix.
struct PrincipalAxes {
  Eigen::Vector3d moments;  ///< Moments in g cm^2, ascending.
  Eigen::Matrix3d axes;     ///< Rotation body_from_principal; its columns are the axes.
};

/// Principal moments, ascending, and axes of a symmetric `inertia` in g cm^2. The axes form a
/// proper rotation with a deterministic choice of sign: each of the first two has its component of
/// largest magnitude positive (the first such on a tie). A matrix that is already diagonal gives
/// a signed permutation, exactly. Throws InvalidArgument about "inertia" unless that is finite and,
/// to round-off, symmetric.
PrincipalAxes principal_axes(const Eigen::Matrix3d& inertia);

// Bodies of density 1 g/cm^3 that have this inertia matrix in g cm^2. They lie along its principal
// axes, and are drawn for a body given by its inertia alone. A matrix that no real body has,
// because the triangle inequality of its moments fails, gives a body that is nearly flat. Each
// throws OutOfRange about a moment that is not positive, and InvalidArgument as principal_axes()
// does.

/// A box.
Part equimomental_box(const Eigen::Matrix3d& inertia);

/// An ellipsoid.
Part equimomental_ellipsoid(const Eigen::Matrix3d& inertia);

/// Terence Tao's discs (mathoverflow.net/a/82020): a flat cross with two heavy discs on the axis of
/// the least moment, and two lighter ones on that of the intermediate moment. The two arms and the
/// hub come first, then the heavy discs, then the light ones.
std::array<Part, 7> equimomental_cross(const Eigen::Matrix3d& inertia);

/// A mass at a point.
struct PointMass {
  double mass;               ///< Mass in g.
  Eigen::Vector3d position;  ///< Position in cm.
};

/// Returns six point masses with the mass, the centre of mass and the inertia of a part, so that
/// forces that are linear in the position have the same sum and the same torque on them as on the
/// part. They lie in pairs on the part's own principal axes, each with a sixth of the mass: for a
/// cylinder's z axis at the centres of its ends, for a box at the centres of its faces. Throws as
/// mass_properties() does.
std::array<PointMass, 6> equimomental_points(const Part& part);

}  // namespace twrench::body
