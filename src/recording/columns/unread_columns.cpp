#include "recording/columns/unread_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include "recording/columns/columns.h"
#include "recording/columns/stated_unit.h"

namespace twrench::recording {
namespace {

/// Words of quantities that are no attitude.
constexpr std::array<std::string_view, 52> other_quantities{"a",
                                                            "acc",
                                                            "accel",
                                                            "acceleration",
                                                            "accelerometer",
                                                            "alpha",
                                                            "b",
                                                            "bias",
                                                            "cov",
                                                            "drift",
                                                            "energy",
                                                            "err",
                                                            "error",
                                                            "f",
                                                            "force",
                                                            "g",
                                                            "gps",
                                                            "gravity",
                                                            "gyr",
                                                            "gyro",
                                                            "gyroscope",
                                                            "h",
                                                            "l",
                                                            "lin",
                                                            "linear",
                                                            "m",
                                                            "mag",
                                                            "magnetic",
                                                            "magfield",
                                                            "momentum",
                                                            "omega",
                                                            "p",
                                                            "pos",
                                                            "position",
                                                            "pressure",
                                                            "r",
                                                            "rate",
                                                            "rates",
                                                            "speed",
                                                            "std",
                                                            "stddev",
                                                            "tau",
                                                            "temp",
                                                            "torque",
                                                            "v",
                                                            "var",
                                                            "vel",
                                                            "velocity",
                                                            "w",
                                                            "angvel",
                                                            "magnetometer",
                                                            "angular"};

/// The name without the word for its component; nothing if it has none, or names another quantity.
std::optional<std::string> stem_of(const std::string& name) {
  std::vector<std::string> words = words_of(name);
  const auto ends_with_unit = [&] {
    const StatedUnit unit = stated_unit({words.back()});
    return words.size() > 1 && (unit.rate || unit.time);
  };
  if (words.empty()) return std::nullopt;
  while (ends_with_unit()) words.pop_back();
  std::string& last = words.back();
  constexpr std::string_view components = "wxyz0123";
  if (components.find(last.back()) == std::string_view::npos) return std::nullopt;
  last.pop_back();
  if (words.size() == 1 && last.empty()) return std::nullopt;
  const auto is_other = [](const std::string& word) {
    return std::ranges::find(other_quantities, word) != other_quantities.end();
  };
  if (std::ranges::any_of(words, is_other)) return std::nullopt;
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

std::vector<std::string> possible_attitude_columns(const table::Header& header,
                                                   const Convention& convention) {
  if (attitude_form(convention) != AttitudeForm::none) return {};
  std::map<std::string, std::vector<std::string>> by_stem;
  for (std::size_t i = 0; i < header.names.size(); ++i) {
    const std::string name = name_for(header, i);
    const bool is_used = std::ranges::any_of(
        convention.columns, [&](const auto& column) { return column.second == name; });
    const auto stem = is_used ? std::nullopt : stem_of(header.names[i]);
    if (stem) by_stem[*stem].push_back(name);
  }
  std::vector<std::string> columns;
  constexpr std::size_t least = 3;
  for (const auto& [stem, names] : by_stem) {
    if (names.size() >= least) columns.insert(columns.end(), names.begin(), names.end());
  }
  return columns;
}

}  // namespace twrench::recording
