#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "recording/conventions/body_axes.h"
#include "recording/rows.h"

namespace twrench::check {

/// The change of rows to another convention.
struct Change {
  double factor = 1;  ///< of the rates
  recording::BodyAxes axes = {};
  bool from_space_axes = false;
  Eigen::Matrix3d offset = Eigen::Matrix3d::Identity();  ///< as Convention::offset
  /// Takes the rates to the vectors in the file: the inertia if these are angular momenta.
  Eigen::Matrix3d file_from_rates = Eigen::Matrix3d::Identity();
};

/// Converts rows as RowDecoder would, without reading the file again.
std::vector<recording::Row> changed(std::span<const recording::Row> rows, const Change& change);

/// Whether the physics cannot distinguish the axes: a rotation that leaves the inertia unchanged
/// takes motions to motions.
bool are_equivalent(const Eigen::Matrix3d& inertia, const recording::BodyAxes& a,
                    const recording::BodyAxes& b);

/// Axes that the physics can distinguish, including `first`.
std::vector<recording::BodyAxes> distinct_axes(const Eigen::Matrix3d& inertia,
                                               const recording::BodyAxes& first);

/// The relative standard deviation of |L| and of the energy over the rows, whichever is larger. It
/// does not depend on the unit of the rates.
double variation(const Eigen::Matrix3d& inertia, std::span<const recording::Row> rows);

/// The fixed rotation from the axes of the rows' attitude to those of their rates, by least squares
/// (Wahba's problem) over turns of about a radian. `turned` are the rows converted to `axes`, in
/// which the rates follow the motion.
Eigen::Matrix3d offset_between(const Eigen::Matrix3d& inertia, std::span<const recording::Row> rows,
                               std::span<const recording::Row> turned,
                               const recording::BodyAxes& axes);

/// Whether rows at the same times have the same motion, up to a rotation of the space frame, and to
/// one of the body that leaves its inertia unchanged.
bool are_same_motion(const Eigen::Matrix3d& inertia, std::span<const recording::Row> a,
                     std::span<const recording::Row> b);

}  // namespace twrench::check
