#include "table/stk_attitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

#include "base/words.h"
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
constexpr std::array<Attitudes, 6> read_attitudes{
    {{"attitudetimequaternions", "t qx qy qz qw"},
     {"attitudetimequatscalarfirst", "t qw qx qy qz"},
     {"attitudetimequatangvels", "t qx qy qz qw wx_deg_s wy_deg_s wz_deg_s"},
     {"attitudetimedcm", "t x11 x21 x31 x12 x22 x32 x13 x23 x33"},
     {"attitudetimeeulerangles", ""},
     {"attitudetimeyprangles", "t yaw_deg pitch_deg roll_deg"}}};

/// The axes of a sequence in a file, such as 321 or YPR: "zyx".
std::string axes_of(std::string_view line) {
  std::string axes;
  for (const char c : trimmed(line.substr(std::min(line.find_first_of(" \t"), line.size())))) {
    constexpr std::string_view known = "123rpyRPY", meant = "xyzxyzxyz";
    const std::size_t found = known.find(c);
    if (found != std::string_view::npos) axes += meant[found];
  }
  return axes.size() == 3 ? axes : std::string();
}

/// The names of Euler angles in the order of their turns. Their places are those of roll, pitch and
/// yaw about x, y and z, unless an axis occurs twice.
std::string names_of_angles(const std::string& axes) {
  std::string names = "t";
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr std::array<const char*, 3> by_axis{" roll_deg", " pitch_deg", " yaw_deg"},
        by_place{" yaw_deg", " pitch_deg", " roll_deg"};
    const bool has_three = !axes.empty() && axes[0] != axes[2];
    names += has_three ? by_axis.at(static_cast<std::size_t>(axes[i] - 'x')) : by_place.at(i);
  }
  return names;
}

}  // namespace

bool is_of_stk(std::string_view start) {
  return to_lower(system::without_byte_order_mark(start).substr(0, 6)) == "stk.v.";
}

StkTable table_of_stk(const Input& input) {
  auto text = std::make_shared<std::string>();
  std::string sequence;
  bool has_names = false, has_end = false;
  LineReader lines(input);
  for (std::string_view line; lines.next(line);) {
    const std::string_view phrase = trimmed(line);
    const std::string keyword = to_lower(phrase.substr(0, phrase.find_first_of(" \t")));
    const auto* const found = std::ranges::find(read_attitudes, keyword, &Attitudes::keyword);
    has_end = has_end || to_lower(phrase).starts_with("end attitude");
    if (keyword == "sequence") sequence = axes_of(phrase);
    if (found != read_attitudes.end() && !has_names) {
      *text += found->names.empty() ? names_of_angles(sequence) : found->names;
      has_names = true;
      // STK turns yaw, pitch and roll about the axes of reference: the last turn is the first about
      // axes that turn with the body.
      if (!found->names.empty()) std::ranges::reverse(sequence);
    } else if (has_names && !has_end) {
      *text += line;
    } else if (keyword.starts_with("attitudetime") && !has_names) {
      throw system::FileError(lines.place(),
                              fmt::format("its attitudes are {}, which are not read", phrase),
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
  return {{input.name(), std::shared_ptr<const std::string>(std::move(text))}, sequence};
}

}  // namespace twrench::table
