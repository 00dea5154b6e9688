#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "check/conventions/convention.h"

namespace twrench::check {

/// Throws table::BadTable about the row from which on |L|, which a free body keeps, or the time
/// between rows is another by a factor that units have, and stays so. Otherwise throws as RowReader
/// does.
void require_one_unit(const std::filesystem::path& file, const Convention& convention,
                      const Eigen::Matrix3d& inertia);

}  // namespace twrench::check
