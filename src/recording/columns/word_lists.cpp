#include "recording/columns/word_lists.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace twrench::recording {

bool is_in(List list, std::string_view word) { return std::ranges::find(list, word) != list.end(); }

bool has_any(const Words& words, List list) {
  return std::ranges::any_of(words, [&](const std::string& word) { return is_in(list, word); });
}

bool has_only(const Words& words, List list) {
  return std::ranges::all_of(words, [&](const std::string& word) { return is_in(list, word); });
}

Words without(const Words& words, std::size_t first, std::size_t count) {
  Words rest = words;
  const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(first);
  rest.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  return rest;
}

std::optional<std::size_t> component_of(const Alphabet& alphabet, std::string_view word) {
  for (std::size_t i = 0; i < alphabet.components.size(); ++i) {
    if (std::ranges::find(alphabet.components[i], word) != alphabet.components[i].end()) return i;
  }
  return std::nullopt;
}

std::string group_of(const Alphabet& alphabet, const Words& words, const std::string& component) {
  const auto at = std::ranges::find(words, component) - words.begin();
  const Words others = without(words, static_cast<std::size_t>(at));
  return fmt::format("{}:{}", alphabet.name, fmt::join(others, " "));
}

const std::vector<Alphabet>& vector_axes() {
  static const std::vector<Alphabet> axes{{"xyz", {{"x"}, {"y"}, {"z"}}},
                                          {"123", {{"1"}, {"2"}, {"3"}}},
                                          {"012", {{"0"}, {"1"}, {"2"}}}};
  return axes;
}

std::optional<std::size_t> joined_component(const Words& words, List stems) {
  if (words.size() != 1 || words[0].size() < 2) return std::nullopt;
  const std::string_view word = words[0];
  if (!is_in(stems, word.substr(0, word.size() - 1))) return std::nullopt;
  return component_of(vector_axes().front(), word.substr(word.size() - 1));
}

bool is_owner(std::string_view word) {
  return is_in({"field", "msg", "message", "data", "imu", "sensor", "device", "phone", "motion",
                "state", "pose", "raw", "measured", "meas", "calibrated", "filtered"},
               word);
}

bool is_frame_pair(std::string_view word) {
  return word.size() == 2 && word[0] != word[1] &&
         word.find_first_not_of("bsrniwegc") == std::string_view::npos;
}

bool are_of_other_quantity(const Words& words) {
  // b_w_RS_S_x is a bias.
  if (words.size() > 1 && words[0] == "b" && is_in({"w", "omega", "g", "gyro"}, words[1])) {
    return true;
  }
  return has_any(words, {"acc",        "accel",     "acceleration", "accelerometer", "alpha",
                         "baro",       "bias",      "clip",         "cmd",           "command",
                         "commanded",  "count",     "cov",          "covariance",    "delta",
                         "derivative", "des",       "desired",      "dot",           "drift",
                         "energy",     "err",       "error",        "force",         "gain",
                         "gps",        "gravity",   "jerk",         "lin",           "linear",
                         "limit",      "mag",       "magfield",     "magnetic",      "magnetometer",
                         "marker",     "max",       "min",          "momentum",      "motor",
                         "noise",      "offset",    "pos",          "position",      "pressure",
                         "ref",        "reference", "reset",        "rotor",         "scale",
                         "setpoint",   "sp",        "std",          "stddev",        "target",
                         "tau",        "temp",      "temperature",  "torque",        "translation",
                         "var",        "variance",  "voltage",      "wheel"});
}

bool is_rate_in_radians_or_degrees(const StatedUnit& unit) {
  return unit.is_per_second && (unit.rate == RateUnit::rad_s || unit.rate == RateUnit::deg_s);
}

}  // namespace twrench::recording
