#include "recording/conventions/names.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "base/enumeration.h"

namespace twrench::recording {
namespace {

struct KindRow {
  Kind kind;
  const char* description;
  std::array<const char*, 9> names;  ///< null after the last
};

constexpr std::array kind_rows{
    KindRow{Kind::time, "the time", {"t"}},
    KindRow{Kind::rates, "the rates", {"wx", "wy", "wz"}},
    KindRow{Kind::momentum, "the angular momentum", {"lx", "ly", "lz"}},
    KindRow{Kind::matrix,
            "the matrix",
            {"x11", "x12", "x13", "x21", "x22", "x23", "x31", "x32", "x33"}},
    KindRow{Kind::quaternion, "the quaternion", {"qw", "qx", "qy", "qz"}},
    KindRow{Kind::euler, "the Euler angles", {"yaw", "pitch", "roll"}},
    KindRow{Kind::rotation_vector, "the rotation vector", {"rvx", "rvy", "rvz"}},
    KindRow{Kind::axis_angle, "the axis and angle", {"axisx", "axisy", "axisz", "angle"}},
    KindRow{Kind::mrp, "the modified Rodrigues parameters", {"mrpx", "mrpy", "mrpz"}},
    KindRow{Kind::rodrigues, "the Rodrigues parameters", {"gibbsx", "gibbsy", "gibbsz"}}};
static_assert(has_row_for_each(kind_rows, &KindRow::kind));

std::map<Kind, std::vector<std::string>> names_of_kinds() {
  std::map<Kind, std::vector<std::string>> names;
  for (const KindRow& row : kind_rows) {
    names[row.kind] = {row.names.begin(), std::ranges::find(row.names, nullptr)};
  }
  return names;
}

}  // namespace

const std::vector<std::string>& names_of(Kind kind) {
  static const std::map<Kind, std::vector<std::string>> names = names_of_kinds();
  return names.at(kind);
}

std::vector<std::string> all_names() {
  std::vector<std::string> all;
  for (const Kind kind : enumerators<Kind>)
    std::ranges::copy(names_of(kind), std::back_inserter(all));
  return all;
}

const char* description_of(Kind kind) {
  return std::ranges::find(kind_rows, kind, &KindRow::kind)->description;
}

}  // namespace twrench::recording
