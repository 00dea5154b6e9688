// The words of rates and of angular momenta.
#include <algorithm>
#include <array>

#include "recording/columns/stated_unit.h"
#include "recording/columns/word_lists.h"

namespace twrench::recording {
namespace {

/// Whether the words place the components in space axes: a frame after a pair of frames, as in
/// omega_BN_N, or the last word of root_ang_vel_w, as Isaac Lab abbreviates the world.
bool is_resolved_in_space(const Words& words) {
  if (has_any(words, {"space", "world", "global", "par"})) return true;
  if (has_any(words, {"root", "link"}) && words.back() == "w") return true;
  const auto pair = std::ranges::find_if(words, is_frame_pair);
  return pair != words.end() && pair + 1 != words.end() &&
         is_in({"n", "r", "i", "w", "e", "g"}, *(pair + 1));
}

/// Whether the words other than the axis are those of an angular velocity.
bool are_of_rates(const Words& words) {
  if (words == Words{"w", "a"}) return true;  // Modelica: the body's, about the axes of its frame_a
  const List rates{"omega", "w",     "gyro",   "gyroscope", "gyr",  "angvel",
                   "rate",  "rates", "omegas", "av",        "wvel", "pqr"};
  const List about{"ang", "angular", "rotation", "rotational"};
  const List of_motion{"vel", "velocity", "velocities", "speed", "twist"};
  const List frames{"inertial", "ei", "eci", "earth"};
  const List others{"body", "b",   "wrt",  "space", "world", "global", "local",
                    "loc",  "par", "root", "link",  "true",  "axis"};
  const bool is_in_space = is_resolved_in_space(words);
  for (const std::string& word : words) {
    const bool is_known = is_in(rates, word) || is_in(about, word) || is_in(of_motion, word) ||
                          is_in(frames, word) || is_in(others, word) || is_owner(word) ||
                          is_frame_pair(word) ||
                          (is_in_space && is_in({"n", "r", "i", "e", "g"}, word));
    if (!is_known) return false;
  }
  if (are_of_other_quantity(words) || has_any(words, {"sigma"})) return false;
  // "omega_inertial_x" may be in the axes of inertial space, or relative to it.
  if (has_any(words, frames) && !has_any(words, {"body", "wrt"})) return false;
  return has_any(words, rates) || (has_any(words, about) && has_any(words, of_motion));
}

/// The words before those of a unit, which begins with N m s or kg m^2.
Words without_unit_of_momentum(const Words& words) {
  constexpr std::array<std::string_view, 5> units{"n", "nm", "nms", "kg", "kgm"};
  return {words.begin(), std::ranges::find_first_of(words, units)};
}

}  // namespace

void add_rates(const Words& all_words, std::vector<Role>& roles) {
  static const std::vector<Alphabet> axes{{"xyz", {{"x"}, {"y"}, {"z"}}},
                                          {"rpy", {{"roll"}, {"pitch"}, {"yaw"}}},
                                          {"pqr", {{"p"}, {"q"}, {"r"}}},
                                          {"123", {{"1"}, {"2"}, {"3"}}},
                                          {"012", {{"0"}, {"1"}, {"2"}}}};
  const StatedUnit unit = stated_unit(all_words);
  const Words& words = unit.other_words;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Words rest = without(words, i);
    // gx is an acceleration of gravity, too, unless its unit or its device says otherwise.
    const bool is_of_gyroscope =
        is_rate_in_radians_or_degrees(unit) ? rest.empty() : rest == Words{"imu"};
    const auto joined = joined_component({words[i]}, {"g"});
    if (joined && is_of_gyroscope) {
      roles.push_back({group_of({"g", {}}, all_words, words[i]), *joined});
    }
    for (const Alphabet& alphabet : axes) {
      const auto component = component_of(alphabet, words[i]);
      if (!component) continue;
      // "AsX(deg/s)": its unit makes it a rate, whatever the name of the quantity is.
      const bool has_axis = alphabet.name == "xyz" || alphabet.name == "rpy";
      const bool is_rate_by_unit = has_axis && is_rate_in_radians_or_degrees(unit) &&
                                   !are_of_other_quantity(words) &&
                                   !has_any(rest, {"inertial", "ei", "eci", "earth"});
      const bool is_known =
          alphabet.name == "pqr" ? has_only(rest, {"body", "rate"}) : are_of_rates(rest);
      if (!is_known && !is_rate_by_unit) continue;
      roles.push_back(
          {group_of(alphabet, all_words, words[i]), *component, is_resolved_in_space(rest), false});
    }
  }
}

void add_momentum(const Words& all_words, std::vector<Role>& roles) {
  const Words words = without_unit_of_momentum(all_words);
  const List in_space{"space", "world", "inertial", "eci"};
  const List frames{"body", "b"};
  const auto is_frame = [&](const std::string& word) {
    return is_in(frames, word) || is_in(in_space, word);
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    Words rest = without(words, i);
    std::erase_if(rest, is_frame);
    const bool is_whole = joined_component({words[i]}, {"l", "h"}).has_value();
    const bool is_named =
        rest == Words{"l"} || rest == Words{"h"} || rest == Words{"angmom"} ||
        (has_any(rest, {"angular", "ang"}) && has_any(rest, {"momentum", "mom"}) &&
         has_only(rest, {"angular", "ang", "momentum", "mom", "l", "h"}));
    if (is_whole && rest.empty()) {
      roles.push_back({group_of({words[i].substr(0, 1), {}}, all_words, words[i]),
                       *joined_component({words[i]}, {"l", "h"}), has_any(words, in_space), false,
                       true});
    }
    for (const Alphabet& alphabet : vector_axes()) {
      const auto component = component_of(alphabet, words[i]);
      if (!component || !is_named) continue;
      roles.push_back({group_of(alphabet, all_words, words[i]), *component,
                       has_any(words, in_space), false, true});
    }
  }
}

}  // namespace twrench::recording
