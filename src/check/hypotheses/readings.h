#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "check/conventions/convention.h"
#include "check/verdict/physics.h"

namespace twrench::check {

/// A way to read a file, and how well its first rows then follow the motion of the body.
struct Reading {
  Convention convention;
  Misfit misfit;
};

/// Judges each convention by the first rows of the file. Throws as RowReader does, except that rows
/// which a convention does not allow are a reading that fits nothing.
std::vector<Reading> readings(const std::filesystem::path& file, const Eigen::Matrix3d& inertia,
                              std::span<const Convention> conventions);

/// Returns the only reading that fits, where each other one fits far worse; else nothing.
std::optional<Reading> only_fitting(std::vector<Reading> readings);

}  // namespace twrench::check
