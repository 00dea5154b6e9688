#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "check/conventions/body_axes.h"
#include "check/reading/row.h"

namespace twrench::check {

/// How rows are taken to those of another convention.
struct Change {
  double factor = 1;  ///< of the rates
  BodyAxes axes = {};
  bool rates_in_space = false;
  Eigen::Matrix3d offset = Eigen::Matrix3d::Identity();  ///< as Convention::offset
};

/// As RowDecoder has it, without reading the file again.
std::vector<Row> changed(std::span<const Row> rows, const Change& change);

/// Whether the physics cannot tell the axes apart: a rotation that takes the inertia to itself
/// takes a motion to a motion.
bool are_alike(const Eigen::Matrix3d& inertia, const BodyAxes& a, const BodyAxes& b);

/// Axes that the physics can tell apart, `first` among them.
std::vector<BodyAxes> distinct_axes(const Eigen::Matrix3d& inertia, const BodyAxes& first);

/// The relative standard deviation of |L| and of the energy over the rows, whichever is larger. It
/// does not depend on the unit of the rates.
double variation(const Eigen::Matrix3d& inertia, std::span<const Row> rows);

/// The fixed rotation from the axes whose attitude the rows have to those of their rates, by least
/// squares (Wahba's problem) over turns of about a radian. `turned` are the rows with the axes that
/// the physics of the rates asks for.
Eigen::Matrix3d offset_between(const Eigen::Matrix3d& inertia, std::span<const Row> rows,
                               std::span<const Row> turned, const BodyAxes& axes);

/// Whether rows at the same times have the same motion, seen from space frames that differ by a
/// rotation.
bool are_same_motion(std::span<const Row> a, std::span<const Row> b);

}  // namespace twrench::check
