#pragma once

#include <optional>
#include <span>
#include <vector>

#include "check/verdict/physics.h"
#include "recording/conventions/convention.h"
#include "recording/recording.h"

namespace twrench::check {

/// A way to read a file, and how well its first rows then follow the motion of the body.
struct Reading {
  recording::Convention convention;
  Misfit misfit;
};

/// Judges each convention by the first rows. Throws as RowReader does, except that a
/// convention that does not allow the rows gets an infinite misfit.
std::vector<Reading> readings(const recording::Recording& recording, const Eigen::Matrix3d& inertia,
                              std::span<const recording::Convention> conventions);

/// Returns the reading that fits if all others fit far worse; otherwise nothing.
std::optional<Reading> only_fitting(std::vector<Reading> readings);

}  // namespace twrench::check
