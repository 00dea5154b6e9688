#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twrench::recording {

/// The quantities that columns can give together.
enum class Kind {
  time,
  rates,
  momentum,
  matrix,
  quaternion,
  euler,
  rotation_vector,
  axis_angle,
  mrp,
  rodrigues
};

/// Our names of the columns of a kind, in their order: "wx", "wy", "wz"; "lx", "ly", "lz"; "x11",
/// "x12" ... "x33"; "qw", "qx", "qy", "qz"; "yaw", "pitch", "roll"; "rvx", "rvy", "rvz" ...
const std::vector<std::string>& names_of(Kind kind);

/// All of our names.
std::vector<std::string> all_names();

/// "the rates", "the matrix" ...
const char* description_of(Kind kind);

}  // namespace twrench::recording
