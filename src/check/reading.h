#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "check/convention.h"
#include "check/physics.h"

namespace twrench::check {

/// A way to read a file, and how well its first rows then follow the motion of the body.
struct Reading {
  Convention convention;
  /// Which of the given moments belongs to each axis: {0, 1, 2} in the given order.
  std::array<int, 3> moment_order{0, 1, 2};
  Misfit misfit;
};

/// Judges each convention by the first rows of the file. Throws as RowReader does, except that rows
/// which a convention does not allow are a reading that fits nothing.
std::vector<Reading> readings(const std::filesystem::path& file, const Eigen::Matrix3d& inertia,
                              std::span<const Convention> conventions);

/// Returns the only reading that fits, where each other one fits far worse; else nothing.
std::optional<Reading> only_fitting(std::vector<Reading> readings);

/// Returns what else the file may mean where it does not fit as it is read: the other unit, the
/// inverse attitude, rates in the other axes, another order of the quaternion's components or of
/// the rotations of Euler angles, each alone and together.
std::vector<Convention> variants(const Convention& convention);

/// Returns the only reading of the file that fits, of variants(convention) with the body as it is,
/// and of `convention` with the moments of a diagonal `inertia` in another order.
std::optional<Reading> fitting_variant(const std::filesystem::path& file,
                                       const Eigen::Matrix3d& inertia,
                                       const Convention& convention);

}  // namespace twrench::check
