#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::recording {

/// The axes of the body along which the first, second and third axis of a file point: a permutation
/// with signs. "x,-z,y": the file's second axis is the body's -z, its third the body's y.
struct BodyAxes {
  std::array<int, 3> axis{0, 1, 2};  ///< 0, 1, 2 for x, y, z
  std::array<int, 3> sign{1, 1, 1};

  friend bool operator==(const BodyAxes&, const BodyAxes&) = default;

  /// Takes components in the body's axes to those in the file's. The determinant is -1 for a
  /// left-handed file.
  Eigen::Matrix3d matrix() const;
};

/// Reads "x,-z,y". Throws InvalidArgument about `quantity` unless each axis occurs once.
BodyAxes parse_body_axes(std::string_view text, const std::string& quantity);

/// The inverse of parse_body_axes.
std::string format_body_axes(const BodyAxes& axes);

/// All 48, sorted by the number of negated axes, then by the number of exchanged ones.
const std::vector<BodyAxes>& all_body_axes();

}  // namespace twrench::recording
