#pragma once

#include <Eigen/Core>
#include <numbers>
#include <vector>

#include "picture/shapes/rings.h"

// Functions that build the surfaces of several shapes.

namespace twrench::picture {

inline constexpr double quarter = std::numbers::pi / 2;

// Minimum number of chords per quarter turn, however small the picture: normals are interpolated
// linearly.
inline constexpr int least_of_body = 8;
inline constexpr int least_of_bevel = 2;

inline constexpr double least_bevel = 12;  // in tolerances

/// Returns how many chords a quarter of a circle of `radius` needs to deviate by at most
/// `tolerance`.
int chords_of_quarter(double radius, double tolerance, int least);

/// Returns the radius of a bevel, a share of half the smallest dimension.
double bevel_of(double half, double share, double tolerance);

/// The same for the rims of a solid of revolution.
double rim_bevel(double radius, double length, double tolerance);

Eigen::Vector3d on_unit_sphere(double longitude, double latitude);

/// Returns angles from `first` to `last`, both included.
std::vector<double> evenly_spaced(double first, double last, int count);

/// Returns the latitudes of the bevel at the end -1 or +1 of a shape, in ascending order.
std::vector<double> bevel_latitudes(double end, int chords);

/// An arc of the outline of a solid of revolution, in the half plane (distance from the axis, z).
/// Straight lines connect consecutive arcs.
struct Arc {
  Eigen::Vector2d centre;
  double radius;
  std::vector<double> latitudes;  ///< The directions of the normals at its points.
};

/// Rotates an outline about the z axis; it goes upwards on the outside.
Rings lathed(const std::vector<Arc>& outline, double widest, double tolerance);

}  // namespace twrench::picture
