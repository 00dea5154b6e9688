#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "check/conventions/convention.h"

namespace twrench::check {

/// Throws table::BadTable if |L|, which a free body conserves, or the time between rows changes by
/// the ratio of two units and stays changed; the error names the row where that begins. Otherwise
/// throws as RowReader does.
void require_one_unit(const std::filesystem::path& file, const Convention& convention,
                      const Eigen::Matrix3d& inertia, const std::atomic<bool>* stop);

}  // namespace twrench::check
