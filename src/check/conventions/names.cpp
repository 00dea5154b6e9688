#include "check/conventions/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace twrench::check {
namespace {

std::vector<std::string> matrix_names() {
  std::vector<std::string> names;
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 3; ++j) names.push_back(fmt::format("x{}{}", i, j));
  }
  return names;
}

}  // namespace

const std::vector<std::string>& names_of(Kind kind) {
  static const std::array<std::vector<std::string>, all_kinds.size()> names{
      {{"t"},
       {"wx", "wy", "wz"},
       matrix_names(),
       {"qw", "qx", "qy", "qz"},
       {"yaw", "pitch", "roll"}}};
  return names.at(static_cast<std::size_t>(kind));
}

std::vector<std::string> all_names() {
  std::vector<std::string> all;
  for (const Kind kind : all_kinds) std::ranges::copy(names_of(kind), std::back_inserter(all));
  return all;
}

const char* description_of(Kind kind) {
  constexpr std::array descriptions{"the time", "the rates", "the matrix", "the quaternion",
                                    "the Euler angles"};
  return descriptions.at(static_cast<std::size_t>(kind));
}

}  // namespace twrench::check
