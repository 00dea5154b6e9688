#include "recording/columns/column_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "recording/columns/stated_unit.h"

namespace twrench::recording {
namespace {

using Words = std::vector<std::string>;
using List = std::initializer_list<std::string_view>;

bool is_in(List list, std::string_view word) { return std::ranges::find(list, word) != list.end(); }

bool has_any(const Words& words, List list) {
  return std::ranges::any_of(words, [&](const std::string& word) { return is_in(list, word); });
}

bool has_only(const Words& words, List list) {
  return std::ranges::all_of(words, [&](const std::string& word) { return is_in(list, word); });
}

Words without(const Words& words, std::size_t first, std::size_t count = 1) {
  Words rest = words;
  const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(first);
  rest.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  return rest;
}

/// The words for the components of a set, in order. A component may have several words.
struct Alphabet {
  std::string_view name;
  std::vector<std::vector<std::string_view>> components;
};

std::optional<std::size_t> component_of(const Alphabet& alphabet, std::string_view word) {
  for (std::size_t i = 0; i < alphabet.components.size(); ++i) {
    if (std::ranges::find(alphabet.components[i], word) != alphabet.components[i].end()) return i;
  }
  return std::nullopt;
}

/// A group consists of all words except the component's: p in deg/s and p in rad/s are in different
/// groups.
std::string group_of(const Alphabet& alphabet, const Words& words, const std::string& component) {
  const auto at = std::ranges::find(words, component) - words.begin();
  const Words others = without(words, static_cast<std::size_t>(at));
  return fmt::format("{}:{}", alphabet.name, fmt::join(others, " "));
}

/// Words for the message, the device or the state to which a quantity belongs.
bool is_owner(std::string_view word) {
  return is_in({"field", "msg", "message", "data", "imu", "sensor", "device", "phone", "motion",
                "state", "pose", "raw", "measured", "meas", "calibrated", "filtered"},
               word);
}

/// The letters of two frames, as in omega_BN: that of the body (B) relative to inertial space (N).
bool is_frame_pair(std::string_view word) {
  return word.size() == 2 && word[0] != word[1] &&
         word.find_first_not_of("bsrniwegc") == std::string_view::npos;
}

/// Whether the letter after a pair of frames places the components in space axes: omega_BN_N.
bool is_resolved_in_space(const Words& words) {
  const auto pair = std::ranges::find_if(words, is_frame_pair);
  return pair != words.end() && pair + 1 != words.end() &&
         is_in({"n", "r", "i", "w", "e", "g"}, *(pair + 1));
}

/// Whether the words mean something that is derived from rates or that rates should follow.
bool are_of_other_quantity(const Words& words) {
  // b_w_RS_S_x is a bias.
  if (words.size() > 1 && words[0] == "b" && is_in({"w", "omega", "g", "gyro"}, words[1])) {
    return true;
  }
  return has_any(
      words,
      {"bias",  "cov",        "covariance", "setpoint",  "sp",    "target",    "desired",
       "des",   "cmd",        "command",    "commanded", "ref",   "reference", "error",
       "err",   "std",        "stddev",     "sigma",     "var",   "variance",  "noise",
       "scale", "offset",     "reset",      "delta",     "acc",   "accel",     "acceleration",
       "alpha", "derivative", "dot",        "jerk",      "limit", "max",       "temperature",
       "temp",  "mag",        "wheel",      "rotor",     "motor"});
}

/// Whether the words other than the axis are those of an angular velocity.
bool are_of_rates(const Words& words) {
  const List rates{"omega", "w", "gyro", "gyroscope", "gyr", "angvel", "rate", "rates"};
  const List about{"ang", "angular", "rotation", "rotational"};
  const List of_motion{"vel", "velocity", "speed", "twist"};
  const List frames{"inertial", "ei", "eci", "earth"};
  const List others{"body", "b", "wrt", "space", "world", "global", "true", "axis"};
  const bool is_in_space = is_resolved_in_space(words);
  for (const std::string& word : words) {
    const bool is_known = is_in(rates, word) || is_in(about, word) || is_in(of_motion, word) ||
                          is_in(frames, word) || is_in(others, word) || is_owner(word) ||
                          is_frame_pair(word) ||
                          (is_in_space && is_in({"n", "r", "i", "e", "g"}, word));
    if (!is_known) return false;
  }
  if (are_of_other_quantity(words)) return false;
  // "omega_inertial_x" may be in the axes of inertial space, or relative to it.
  if (has_any(words, frames) && !has_any(words, {"body", "wrt"})) return false;
  return has_any(words, rates) || (has_any(words, about) && has_any(words, of_motion));
}

bool is_rate_in_radians_or_degrees(const StatedUnit& unit) {
  return unit.is_per_second && (unit.rate == RateUnit::rad_s || unit.rate == RateUnit::deg_s);
}

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
      roles.push_back({group_of(alphabet, all_words, words[i]), *component,
                       has_any(rest, {"space", "world", "global"}) || is_resolved_in_space(rest),
                       false});
    }
  }
}

void add_euler(const Words& all_words, std::vector<Role>& roles) {
  static const std::vector<Alphabet> angles{{"ypr", {{"yaw"}, {"pitch"}, {"roll"}}},
                                            {"greek", {{"psi"}, {"theta"}, {"phi"}}},
                                            {"hpr", {{"heading"}, {"pitch"}, {"roll"}}},
                                            {"zyx", {{"z"}, {"y"}, {"x"}}},
                                            {"012", {{"0"}, {"1"}, {"2"}}},
                                            {"123", {{"1"}, {"2"}, {"3"}}}};
  const StatedUnit unit = stated_unit(all_words);
  if (is_rate_in_radians_or_degrees(unit)) return;
  const Words& words = unit.other_words;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Words rest = without(words, i);
    for (const Alphabet& alphabet : angles) {
      const auto component = component_of(alphabet, words[i]);
      const bool is_named = is_in({"ypr", "greek", "hpr"}, alphabet.name);
      const bool is_known = (is_named || has_any(rest, {"euler", "eul"})) &&
                            has_only(rest, {"euler", "eul", "angle", "angles", "attitude", "att",
                                            "orientation", "body", "ypr", "rpy"});
      if (!component || !is_known) continue;
      const bool is_numbered = is_in({"012", "123"}, alphabet.name);
      roles.push_back({group_of(alphabet, all_words, words[i]), *component, false, is_numbered,
                       alphabet.name == "hpr"});
    }
  }
}

void add_quaternion(const Words& words, std::vector<Role>& roles) {
  static const std::vector<Alphabet> parts{
      {"wxyz", {{"w", "s", "scalar", "real"}, {"x", "i"}, {"y", "j"}, {"z", "k"}}},
      {"0123", {{"0"}, {"1"}, {"2"}, {"3"}}},
      {"1234", {{"1"}, {"2"}, {"3"}, {"4"}}}};
  if (words.size() < 2) return;
  const Words rest = without(words, words.size() - 1);
  const List orders{"wxyz", "xyzw"};
  const List names{"q", "quat", "quaternion", "orientation", "orient", "attitude", "att"};
  const bool is_known = has_any(rest, names) && std::ranges::all_of(rest, [&](const auto& word) {
                          return is_in(names, word) || is_in(orders, word) ||
                                 is_in({"body", "rotation", "rot"}, word) || is_owner(word) ||
                                 is_frame_pair(word);
                        });
  if (!is_known) return;
  for (const Alphabet& alphabet : parts) {
    const auto component = component_of(alphabet, words.back());
    if (!component) continue;
    const bool is_ordered = has_any(rest, orders);
    const bool is_numbered = alphabet.name != "wxyz";
    const bool is_last = is_numbered && has_any(rest, {"xyzw"});
    roles.push_back({fmt::format("{}:{}", alphabet.name, fmt::join(rest, " ")),
                     is_last ? (*component + 1) % 4 : *component, false,
                     is_numbered && !is_ordered});
  }
}

/// The digit, if the word is one.
std::optional<std::size_t> digit_of(std::string_view word) {
  if (word.size() != 1 || word[0] < '0' || word[0] > '9') return std::nullopt;
  return static_cast<std::size_t>(word[0] - '0');
}

/// Row and column of an entry, from "12" or from "1", "2"; `rest` receives the words before.
std::optional<std::pair<std::size_t, std::size_t>> indices_of(const Words& words, Words& rest) {
  if (words.size() < 2) return std::nullopt;
  const std::string& last = words.back();
  const std::string& before = words[words.size() - 2];
  if (last.size() == 2 && digit_of(last.substr(0, 1)) && digit_of(last.substr(1))) {
    rest = without(words, words.size() - 1);
    return std::pair{*digit_of(last.substr(0, 1)), *digit_of(last.substr(1))};
  }
  if (words.size() < 3 || !digit_of(last) || !digit_of(before)) return std::nullopt;
  rest = without(words, words.size() - 2, 2);
  return std::pair{*digit_of(before), *digit_of(last)};
}

bool are_of_matrix(const Words& words) {
  return !words.empty() &&
         has_only(words, {"x", "r", "rot", "rotation", "dcm", "m", "c", "a", "matrix", "rotmat",
                          "attitude", "att", "orientation", "body"});
}

void add_matrix(const Words& words, std::vector<Role>& roles) {
  Words rest;
  if (const auto indices = indices_of(words, rest); indices && are_of_matrix(rest)) {
    const auto [i, j] = *indices;
    const std::string name = fmt::format("{}", fmt::join(rest, " "));
    if (i < 3 && j < 3) roles.push_back({"from 0:" + name, 3 * i + j, false, false});
    if (i >= 1 && j >= 1 && i <= 3 && j <= 3) {
      roles.push_back({"from 1:" + name, 3 * (i - 1) + j - 1, false, false});
    }
    return;
  }
  if (words.size() < 2) return;
  rest = without(words, words.size() - 1);
  const auto index = digit_of(words.back());
  if (!index || !are_of_matrix(rest)) return;
  // Our own X[0] ... X[8] are row by row; others may be column by column.
  const bool is_open = rest != Words{"x"};
  const std::string name = fmt::format("{}", fmt::join(rest, " "));
  if (*index < 9) roles.push_back({"one from 0:" + name, *index, false, is_open});
  if (*index > 0) roles.push_back({"one from 1:" + name, *index - 1, false, is_open});
}

/// The alphabets of the components of a vector.
const std::vector<Alphabet>& vector_axes() {
  static const std::vector<Alphabet> axes{{"xyz", {{"x"}, {"y"}, {"z"}}},
                                          {"123", {{"1"}, {"2"}, {"3"}}},
                                          {"012", {{"0"}, {"1"}, {"2"}}}};
  return axes;
}

/// Adds the roles of a component of a vector, whose word is the last one. `is_named` is whether the
/// words before it name the vector.
template <typename IsNamed>
void add_vector(const Words& words, const IsNamed& is_named, bool is_weak,
                std::vector<Role>& roles) {
  if (words.size() < 2) return;
  const Words rest = without(words, words.size() - 1);
  if (!is_named(rest)) return;
  for (const Alphabet& alphabet : vector_axes()) {
    const auto component = component_of(alphabet, words.back());
    if (!component) continue;
    roles.push_back({fmt::format("{}:{}", alphabet.name, fmt::join(rest, " ")), *component, false,
                     false, is_weak});
  }
}

/// The component, if the name is one of these stems and an axis in one word: "rotvecx".
std::optional<std::size_t> joined_component(const Words& words, List stems) {
  if (words.size() != 1 || words[0].size() < 2) return std::nullopt;
  const std::string_view word = words[0];
  if (!is_in(stems, word.substr(0, word.size() - 1))) return std::nullopt;
  return component_of(vector_axes().front(), word.substr(word.size() - 1));
}

/// The words before those of a unit, which begins with N m s or kg m^2.
Words without_unit_of_momentum(const Words& words) {
  constexpr std::array<std::string_view, 5> units{"n", "nm", "nms", "kg", "kgm"};
  return {words.begin(), std::ranges::find_first_of(words, units)};
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

void add_rotation_vector(const Words& all_words, std::vector<Role>& roles) {
  const Words words = stated_unit(all_words).other_words;
  const auto is_named = [](const Words& rest) {
    const List names{"rv",        "rotvec",    "rvec",      "prv",
                     "rotvector", "axisangle", "angleaxis", "expmap"};
    const bool is_pair = (has_any(rest, {"rotation", "rot"}) && has_any(rest, {"vector", "vec"})) ||
                         (has_any(rest, {"axis"}) && has_any(rest, {"angle"}));
    return (has_any(rest, names) || is_pair) &&
           std::ranges::all_of(rest, [&](const std::string& word) {
             return is_in(names, word) ||
                    is_in({"rotation", "rot", "vector", "vec", "axis", "angle", "principal",
                           "attitude", "att", "orientation", "body"},
                          word);
           });
  };
  add_vector(words, is_named, false, roles);
  if (const auto component = joined_component(words, {"rv", "rotvec", "rvec"})) {
    roles.push_back({"joined", *component});
  }
  // A vector r is a position, too.
  add_vector(
      words, [](const Words& rest) { return rest == Words{"r"}; }, true, roles);
  if (const auto component = joined_component(words, {"r"})) {
    roles.push_back({"r", *component, false, false, true});
  }
}

void add_axis_angle(const Words& all_words, std::vector<Role>& roles) {
  const Words words = stated_unit(all_words).other_words;
  if (words == Words{"angle"} || words == Words{"theta"} || words == Words{"axis", "angle"}) {
    for (const char* group : {"a", "axis", "xyz:axis", "123:axis", "012:axis"}) {
      roles.push_back({group, 3, false, false, true});
    }
    return;
  }
  const auto is_named = [](const Words& rest) { return rest == Words{"axis"}; };
  add_vector(words, is_named, true, roles);
  // A vector a is an acceleration, too.
  if (const auto component = joined_component(words, {"a"})) {
    roles.push_back({"a", *component, false, false, true});
  }
  if (const auto component = joined_component(words, {"axis"})) {
    roles.push_back({"axis", *component, false, false, true});
  }
}

void add_mrp(const Words& words, std::vector<Role>& roles) {
  const List frames{"bn", "bi", "body"};
  const auto is_named = [&](const Words& rest) {
    const List names{"mrp", "mrps"};
    const bool is_modified = has_any(rest, {"modified"}) && has_any(rest, {"rodrigues"});
    return (has_any(rest, names) || is_modified) &&
           std::ranges::all_of(rest, [&](const std::string& word) {
             return is_in(names, word) || is_in(frames, word) ||
                    is_in({"sigma", "modified", "rodrigues", "parameter", "parameters", "params",
                           "attitude", "att"},
                          word);
           });
  };
  add_vector(words, is_named, false, roles);
  if (const auto component = joined_component(words, {"mrp"}))
    roles.push_back({"joined", *component});
  // sigma_x, sigma_y, sigma_z are rather standard deviations, and sigma_1 ... may be stresses.
  const auto is_sigma = [&](const Words& rest) {
    return rest[0] == "sigma" && has_only(without(rest, 0), frames);
  };
  const bool has_axis = is_in({"x", "y", "z"}, words.back());
  const bool has_frame = has_any(words, frames);
  if (has_frame || !has_axis) add_vector(words, is_sigma, !has_frame, roles);
}

void add_rodrigues(const Words& words, std::vector<Role>& roles) {
  const auto is_named = [](const Words& rest) {
    const List names{"rodrigues", "gibbs", "crp", "crps"};
    return has_any(rest, names) && std::ranges::all_of(rest, [&](const std::string& word) {
             return is_in(names, word) || is_in({"classical", "vector", "parameter", "parameters",
                                                 "params", "bn", "body", "attitude", "att"},
                                                word);
           });
  };
  add_vector(words, is_named, false, roles);
  if (const auto component = joined_component(words, {"gibbs", "crp"})) {
    roles.push_back({"joined", *component});
  }
}

void add_time(const Words& all_words, std::vector<Role>& roles) {
  const StatedUnit unit = stated_unit(all_words);
  const Words& words = unit.other_words;
  const List clocks{"t",    "time", "timestamp", "timestamps", "stamp",    "epoch",
                    "epoc", "ts",   "elapsed",   "datetime",   "unixtime", "utc"};
  const List qualifiers{"sim",   "simulation",  "unix",        "gps",       "system", "sys",
                        "boot",  "since",       "header",      "sample",    "fine",   "host",
                        "log",   "logging",     "chip",        "local",     "date",   "reboot",
                        "start", "measurement", "gyro",        "gyroscope", "rel",    "relative",
                        "abs",   "absolute",    "acquisition", "1970"};
  const bool is_time = has_any(words, clocks) || (unit.time && words.empty());
  const bool is_known = std::ranges::all_of(words, [&](const std::string& word) {
    return is_in(clocks, word) || is_in(qualifiers, word) || is_owner(word);
  });
  if (!is_time || !is_known || unit.rate) return;
  roles.push_back({fmt::format("{}", fmt::join(all_words, " ")), 0, false, false});
}

}  // namespace

std::vector<Role> roles_of(const std::vector<std::string>& words, Kind kind) {
  std::vector<Role> roles;
  if (words.empty()) return roles;
  switch (kind) {
    case Kind::time:
      add_time(words, roles);
      break;
    case Kind::rates:
      add_rates(words, roles);
      break;
    case Kind::momentum:
      add_momentum(words, roles);
      break;
    case Kind::matrix:
      add_matrix(words, roles);
      break;
    case Kind::quaternion:
      add_quaternion(words, roles);
      break;
    case Kind::euler:
      add_euler(words, roles);
      break;
    case Kind::rotation_vector:
      add_rotation_vector(words, roles);
      break;
    case Kind::axis_angle:
      add_axis_angle(words, roles);
      break;
    case Kind::mrp:
      add_mrp(words, roles);
      break;
    case Kind::rodrigues:
      add_rodrigues(words, roles);
      break;
  }
  return roles;
}

}  // namespace twrench::recording
