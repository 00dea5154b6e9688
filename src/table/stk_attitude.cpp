#include "table/stk_attitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

#include "base/letters.h"
#include "system/error.h"
#include "system/file_kind.h"
#include "table/line_reader.h"
#include "table/number_text.h"

namespace twrench::table {
namespace {

/// A keyword before rows, and the names of their columns. The quaternion turns the axes of
/// reference into the body's, the rates are about the body's axes, and the matrix takes components
/// in the axes of reference to those in the body's.
struct Attitudes {
  std::string_view keyword, names;
};
constexpr std::array<Attitudes, 4> read_attitudes{
    {{"attitudetimequaternions", "t qx qy qz qw"},
     {"attitudetimequatscalarfirst", "t qw qx qy qz"},
     {"attitudetimequatangvels", "t qx qy qz qw wx_deg_s wy_deg_s wz_deg_s"},
     {"attitudetimedcm", "t x11 x21 x31 x12 x22 x32 x13 x23 x33"}}};

}  // namespace

bool is_of_stk(std::string_view start) {
  return to_lower(system::without_byte_order_mark(start).substr(0, 6)) == "stk.v.";
}

Input table_of_stk(const Input& input) {
  auto text = std::make_shared<std::string>();
  bool has_names = false, has_end = false;
  LineReader lines(input);
  for (std::string_view line; lines.next(line);) {
    const std::string keyword = to_lower(trimmed(line.substr(0, line.find_first_of(" \t"))));
    const auto* const found = std::ranges::find(read_attitudes, keyword, &Attitudes::keyword);
    has_end = has_end || to_lower(trimmed(line)).starts_with("end attitude");
    if (found != read_attitudes.end() && !has_names) {
      *text += found->names;
      has_names = true;
    } else if (has_names && !has_end) {
      *text += line;
    } else if (keyword.starts_with("attitudetime") && !has_names) {
      throw system::FileError(
          lines.place(), fmt::format("its attitudes are {}, which are not read", trimmed(line)),
          "export AttitudeTimeQuaternions or AttitudeTimeQuatAngVels");
    } else {
      *text += '#';
    }
    *text += '\n';
  }
  if (!has_names || !has_end) {
    throw system::FileError(input.name(),
                            fmt::format("it is cut off: {} is missing",
                                        has_names ? "END Attitude" : "AttitudeTimeQuaternions"),
                            "get the whole attitude file");
  }
  return {input.name(), std::shared_ptr<const std::string>(std::move(text))};
}

}  // namespace twrench::table
