// The words of attitudes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "recording/columns/stated_unit.h"
#include "recording/columns/word_lists.h"

namespace twrench::recording {
namespace {

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
  return !words.empty() && has_only(words, {"x", "r", "t", "rot", "mat", "rotation", "dcm", "m",
                                            "c", "a", "matrix", "rotmat", "attitude", "att",
                                            "orientation", "body", "dcmbe", "dcmbi", "dcmbn"});
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

/// rotation[0] to rotation[3]: a quaternion, or an axis and an angle as of VRML and Webots.
bool is_numbered_rotation(const Words& words) {
  return words.size() == 2 && words[0] == "rotation" && is_in({"0", "1", "2", "3"}, words[1]);
}

}  // namespace

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
  // RX, RY and RZ are rotation vectors or Euler angles.
  if (const auto component = joined_component(words, {"r"}))
    roles.push_back({"r", 2 - *component, false, false, true});
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Words rest = without(words, i);
    for (const Alphabet& alphabet : angles) {
      const auto component = component_of(alphabet, words[i]);
      const bool is_named = is_in({"ypr", "greek", "hpr"}, alphabet.name);
      // Motion capture calls them "Rotation: X", and other attitudes as well.
      const bool is_rotation =
          (rest == Words{"rotation"} || rest == Words{"angle"}) && alphabet.name == "zyx";
      const bool is_known = (is_named || has_any(rest, {"euler", "eul"})) &&
                            has_only(rest, {"euler", "eul", "angle", "angles", "attitude", "att",
                                            "orientation", "body", "ypr", "rpy"});
      if (!component || !(is_known || is_rotation)) continue;
      const bool is_numbered = is_in({"012", "123"}, alphabet.name);
      roles.push_back({group_of(alphabet, all_words, words[i]), *component, false, is_numbered,
                       alphabet.name == "hpr" || is_rotation});
    }
  }
}

void add_quaternion(const Words& all_words, std::vector<Role>& roles) {
  // SensorLog marks columns that count from a reference: motionQuaternionW(R).
  const std::size_t count = all_words.size();
  const bool has_mark =
      count > 2 && all_words.back() == "r" && is_in({"w", "x", "y", "z"}, all_words[count - 2]);
  const Words words = has_mark ? without(all_words, count - 1) : all_words;
  static const std::vector<Alphabet> parts{
      {"wxyz", {{"w", "s", "scalar", "real", "r"}, {"x", "i"}, {"y", "j"}, {"z", "k"}}},
      {"0123", {{"0"}, {"1"}, {"2"}, {"3"}}},
      {"1234", {{"1"}, {"2"}, {"3"}, {"4"}}}};
  // Vicon's RX, RY, RZ and RW.
  if (const auto component =
          component_of({"wxyz", {{"rw"}, {"rx"}, {"ry"}, {"rz"}}}, words.front());
      component && words.size() == 1) {
    roles.push_back({"r", *component, false, false, true});
  }
  if (words.size() < 2) return;
  const Words rest = without(words, words.size() - 1);
  // The Euler parameters e0 to e3 begin with the scalar.
  const auto digit = digit_of(words.back());
  if (digit && *digit < 4 && (rest == Words{"e"} || rest == Words{"rot", "e"})) {
    roles.push_back({"e", *digit, false, false, true});
    return;
  }
  const List orders{"wxyz", "xyzw"};
  const List names{"q",        "quat", "quaternion", "orientation", "orient",       "ori",
                   "attitude", "att",  "quats",      "quaternions", "orientations", "attitudes",
                   "orn",      "beta", "framequat",  "xquat"};
  const bool is_weak = !has_any(rest, names);
  const bool is_known = (!is_weak || has_any(rest, {"rotation", "rot"})) &&
                        std::ranges::all_of(rest, [&](const auto& word) {
                          return is_in(names, word) || is_in(orders, word) ||
                                 is_in({"body", "base", "root", "link", "world", "rotation", "rot",
                                        "b", "i", "n", "e", "a", "w"},
                                       word) ||
                                 is_owner(word) || is_frame_pair(word);
                        });
  if (!is_known) return;
  for (const Alphabet& alphabet : parts) {
    const auto component = component_of(alphabet, words.back());
    if (!component) continue;
    const bool is_ordered = has_any(rest, orders);
    const bool is_numbered = alphabet.name != "wxyz";
    // Numbers from 1, and others than rotation[0] to rotation[3], are those of a matrix.
    if (is_weak && is_numbered && !is_numbered_rotation(words)) continue;
    const bool is_last = is_numbered && has_any(rest, {"xyzw"});
    roles.push_back({fmt::format("{}:{}", alphabet.name, fmt::join(rest, " ")),
                     is_last ? (*component + 1) % 4 : *component, false, is_numbered && !is_ordered,
                     is_weak});
  }
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
  if (is_numbered_rotation(words))
    roles.push_back({"rotation", *digit_of(words.back()), false, false, true});
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

}  // namespace twrench::recording
