#include "recording/columns/unread_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include "recording/columns/columns.h"
#include "recording/columns/stated_unit.h"
#include "recording/columns/word_lists.h"

namespace twrench::recording {
namespace {

/// The words of a name without its unit and without that for its component; nothing if it has none.
std::optional<Words> stem_of(const std::string& name) {
  Words words = words_of(name);
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
  return words;
}

/// Single letters other than s are those of forces, positions, velocities and the like.
bool is_letter_of_vector(const std::string& word) { return word.size() == 1 && word != "s"; }

bool may_be_attitude(const Words& stem) {
  return !has_any(stem, {"gyr", "gyro", "gyroscope", "omega", "rate", "rates", "speed", "vel",
                         "velocity", "angvel", "angular"}) &&
         !has_any(stem, {"a", "b", "f", "g", "h", "l", "m", "p", "r", "v", "w"});
}

bool may_be_rates(const Words& stem) {
  const bool is_angular = has_any(stem, {"ang", "angular", "gyr", "gyro", "omega", "rotation"});
  const bool is_speed = has_any(stem, {"speed", "vel", "velocity"});
  return (is_angular || !is_speed) && !is_letter_of_vector(stem.front()) &&
         !has_any(stem, {"q", "quat", "quaternion", "euler", "orientation", "attitude", "att",
                         "dcm", "rot", "rotvec", "mrp"});
}

/// Whether the name is that of an Euler angle, even if the others are missing.
bool is_angle(const std::string& name) {
  return std::ranges::any_of(roles_of(name, Kind::euler),
                             [](const Role& role) { return !role.is_weak && !role.is_open; });
}

}  // namespace

std::vector<std::string> unread_columns(const table::Header& header, const Convention& convention) {
  const bool lacks_attitude = attitude_form(convention) == AttitudeForm::none;
  const bool lacks_rates = !has_rates(convention);
  std::vector<std::string> columns;
  std::map<Words, std::vector<std::string>> by_stem;
  for (std::size_t i = 0; i < header.names.size(); ++i) {
    const std::string name = name_for(header, i);
    const bool is_used = std::ranges::any_of(
        convention.columns, [&](const auto& column) { return column.second == name; });
    if (!is_used && lacks_attitude && is_angle(header.names[i])) columns.push_back(name);
    const auto stem = is_used ? std::nullopt : stem_of(header.names[i]);
    if (!stem || are_of_other_quantity(*stem)) continue;
    const bool may_be_lacking =
        (lacks_attitude && may_be_attitude(*stem)) || (lacks_rates && may_be_rates(*stem));
    if (may_be_lacking) by_stem[*stem].push_back(name);
  }
  constexpr std::size_t least = 3;
  for (const auto& [stem, names] : by_stem) {
    if (names.size() >= least) columns.insert(columns.end(), names.begin(), names.end());
  }
  return columns;
}

}  // namespace twrench::recording
