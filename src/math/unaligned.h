#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace twrench::so3 {

// The alignment of Eigen's own types of these sizes depends on compiler flags. The linker may merge
// an inline function of Eigen in the library with the same function in a program, which may have
// been compiled with other flags. A function of the types below assumes no alignment in either
// build.

/// A quaternion whose layout is independent of compiler flags.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// A 4 x 4 matrix whose layout is independent of compiler flags.
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

}  // namespace twrench::so3
