#pragma once

#include <map>
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

/// Reads "t=time,wx=p,wy=q" into our names and the file's. Names of the file that contain a comma
/// or
/// '=', or begin or end with spaces, are quoted ("" for a quote in them): wx="rate, x". Throws
/// InvalidArgument about `quantity` if a name on the left is not one of ours or occurs twice.
std::map<std::string, std::string> parse_columns(std::string_view text,
                                                 const std::string& quantity);

/// The inverse of parse_columns, t first and the others in the order of their kinds.
std::string format_columns(const std::map<std::string, std::string>& columns);

}  // namespace twrench::recording
