#include "recording/columns/column_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "recording/columns/stated_unit.h"
#include "recording/columns/word_lists.h"

namespace twrench::recording {
namespace {

void add_time(const Words& all_words, std::vector<Role>& roles) {
  const StatedUnit unit = stated_unit(all_words);
  const Words& words = unit.other_words;
  const List clocks{"t",    "time",  "timestamp", "timestamps", "stamp",    "epoch",
                    "epoc", "ts",    "elapsed",   "datetime",   "unixtime", "utc",
                    "zeit", "temps", "tiempo",    "tempo"};
  const List qualifiers{
      "sim",   "simulation", "unix",   "gps",      "system", "sys",      "boot",
      "since", "header",     "sample", "fine",     "host",   "log",      "logging",
      "chip",  "local",      "date",   "reboot",   "start",  "in",       "measurement",
      "gyro",  "gyroscope",  "rel",    "relative", "abs",    "absolute", "acquisition",
      "1970",  "clock",      "startup"};
  const bool is_time =
      has_any(words, clocks) || (unit.time && words.empty()) || unit.time == TimeUnit::d;
  const bool is_julian = unit.time == TimeUnit::d;  // "A1ModJulian" counts atomic time
  const bool is_known = std::ranges::all_of(words, [&](const std::string& word) {
    return (is_julian && is_in({"a", "1", "mod", "modified", "tai", "tt", "tdb", "day"}, word)) ||
           is_in(clocks, word) || is_in(qualifiers, word) || is_owner(word) ||
           (word == "offset" && words[0] == "clock");
  });
  // "Shimmer_5E_Timestamp_Unix_CAL (ms)"
  const bool is_stamp =
      unit.time && has_any(words, {"timestamp", "timestamps"}) && !are_of_other_quantity(words);
  if (!is_time || !(is_known || is_stamp) || unit.rate) return;
  roles.push_back({fmt::format("{}", fmt::join(all_words, " ")), 0, false, false});
}

std::vector<Role> roles_of_words(const Words& words, Kind kind) {
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

/// Whether the text begins with a unit of times, as behind the slash of "rad/s".
bool begins_with_time_unit(std::string_view text) {
  const Words words = words_of(text);
  return !words.empty() && stated_unit({words.front()}).time.has_value();
}

/// Where the next point, colon or slash outside brackets is, from `at` on, unless the slash is that
/// of a unit.
std::size_t next_separator(std::string_view name, std::size_t at) {
  const std::string_view before = name.substr(0, at);
  auto depth = std::ranges::count(before, '(') + std::ranges::count(before, '[') -
               std::ranges::count(before, ')') - std::ranges::count(before, ']');
  for (; at < name.size(); ++at) {
    const char c = name[at];
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    const bool is_slash = c == '/' && !begins_with_time_unit(name.substr(at + 1));
    if (depth == 0 && (c == '.' || c == ':' || is_slash)) return at;
  }
  return std::string_view::npos;
}

}  // namespace

std::vector<Role> roles_of(std::string_view name, Kind kind) {
  std::vector<Role> roles = roles_of_words(words_of(name), kind);
  for (std::size_t at = next_separator(name, 0); roles.empty() && at != std::string_view::npos;
       at = next_separator(name, at + 1)) {
    const std::string_view owner = name.substr(0, at);
    if (are_of_other_quantity(words_of(owner))) break;
    roles = roles_of_words(words_of(name.substr(at + 1)), kind);
    for (Role& role : roles) role.group += fmt::format(" of {}", owner);
  }
  return roles;
}

}  // namespace twrench::recording
