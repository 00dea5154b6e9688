#include "recording/columns/stated_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "recording/conventions/units.h"

namespace twrench::recording {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array<Pair, 12> letters{{{"\u03c9", "omega"},
                                        {"\u03a9", "omega"},
                                        {"\u03c6", "phi"},
                                        {"\u03d5", "phi"},
                                        {"\u03b8", "theta"},
                                        {"\u03c8", "psi"},
                                        {"\u00b0", " deg "},
                                        {"\u00b5", "u"},
                                        {"\u03bc", "u"},
                                        {"s^-1", "per s "},
                                        {"s\u207b\u00b9", "per s "},
                                        {"sec^-1", "per s "}}};

/// Words that may precede a component without a separator: "qw", "omegax".
constexpr std::array<std::string_view, 7> prefixes{"w", "omega", "gyro",  "rate",
                                                   "q", "quat",  "angvel"};

// Unlike those of <cctype>, these do not depend on the locale.
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_alpha(char c) { return is_lower(c) || is_upper(c); }
bool is_numeral(char c) { return c >= '0' && c <= '9'; }
char in_lower_case(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }

std::string with_plain_letters(std::string_view name) {
  std::string plain(name);
  for (const auto& [letter, word] : letters) {
    for (std::size_t at = 0; (at = plain.find(letter, at)) != std::string::npos;) {
      plain.replace(at, letter.size(), word);
      at += word.size();
    }
  }
  return plain;
}

/// Whether a word ends between the two characters: rateX, Rate2.
bool is_boundary(char before, char c) {
  return (is_lower(before) && is_upper(c)) || is_alpha(before) != is_alpha(c);
}

/// Adds a word, or its two parts if it is a prefix and an axis.
void add_word(std::vector<std::string>& words, std::string word) {
  if (word.empty()) return;
  for (const char* axis : {"roll", "pitch", "yaw"}) {
    if (word != std::string(axis) + "speed" && word != std::string(axis) + "rate") continue;
    words.emplace_back(axis);
    words.emplace_back("rate");
    return;
  }
  if (word.size() > 1 && word.substr(1) == "rotation") {
    words.emplace_back(1, word.front());
    words.emplace_back("rotation");
    return;
  }
  const std::string stem = word.substr(0, word.size() - 1);
  const bool has_axis = std::string_view("wxyz").find(word.back()) != std::string_view::npos;
  if (has_axis && std::ranges::find(prefixes, stem) != prefixes.end()) {
    words.push_back(stem);
    words.emplace_back(1, word.back());
  } else {
    words.push_back(std::move(word));
  }
}

struct RateWord {
  std::string_view word;
  RateUnit unit;
};
/// Units of angles, and of rates if "per second" follows. Betaflight's gyroADC is in deg/s.
constexpr std::array<RateWord, 16> angle_words{{{"deg", RateUnit::deg_s},
                                                {"degs", RateUnit::deg_s},
                                                {"degree", RateUnit::deg_s},
                                                {"degrees", RateUnit::deg_s},
                                                {"dps", RateUnit::deg_s},
                                                {"adc", RateUnit::deg_s},
                                                {"degps", RateUnit::deg_s},
                                                {"rad", RateUnit::rad_s},
                                                {"rads", RateUnit::rad_s},
                                                {"radian", RateUnit::rad_s},
                                                {"radians", RateUnit::rad_s},
                                                {"radps", RateUnit::rad_s},
                                                {"rev", RateUnit::rev_s},
                                                {"revs", RateUnit::rev_s},
                                                {"rps", RateUnit::rev_s},
                                                {"rpm", RateUnit::rpm}}};
constexpr std::array<std::string_view, 4> unread_words{"turns", "mrad", "cycles", "gon"};

struct TimeWord {
  std::string_view word;
  TimeUnit unit;
};
constexpr std::array<TimeWord, 30> time_words{{{"s", TimeUnit::s},
                                               {"sec", TimeUnit::s},
                                               {"secs", TimeUnit::s},
                                               {"second", TimeUnit::s},
                                               {"seconds", TimeUnit::s},
                                               {"ms", TimeUnit::ms},
                                               {"msec", TimeUnit::ms},
                                               {"msecs", TimeUnit::ms},
                                               {"millis", TimeUnit::ms},
                                               {"millisecond", TimeUnit::ms},
                                               {"milliseconds", TimeUnit::ms},
                                               {"us", TimeUnit::us},
                                               {"usec", TimeUnit::us},
                                               {"micros", TimeUnit::us},
                                               {"microsecond", TimeUnit::us},
                                               {"microseconds", TimeUnit::us},
                                               {"ns", TimeUnit::ns},
                                               {"nsec", TimeUnit::ns},
                                               {"nanos", TimeUnit::ns},
                                               {"nanosecond", TimeUnit::ns},
                                               {"nanoseconds", TimeUnit::ns},
                                               {"mins", TimeUnit::min},
                                               {"minutes", TimeUnit::min},
                                               {"hrs", TimeUnit::h},
                                               {"hours", TimeUnit::h},
                                               {"days", TimeUnit::d},
                                               {"julian", TimeUnit::d},
                                               {"jd", TimeUnit::d},
                                               {"mjd", TimeUnit::d},
                                               {"jdate", TimeUnit::d}}};

/// The unit of time that the word at `at` names. "min" and "h" also mean other things, so they
/// count only after a word for time: "t_min".
std::optional<TimeUnit> time_at(std::span<const std::string> words, std::size_t at) {
  if (at >= words.size()) return std::nullopt;
  const auto found = std::ranges::find(time_words, words[at], &TimeWord::word);
  if (found != time_words.end()) return found->unit;
  constexpr std::array<std::string_view, 3> of_time{"t", "time", "elapsed"};
  if (at == 0 || std::ranges::find(of_time, words[at - 1]) == of_time.end()) return std::nullopt;
  if (words[at] == "min") return TimeUnit::min;
  return words[at] == "h" ? std::optional(TimeUnit::h) : std::nullopt;
}

/// Units of other quantities, as a row of units may state them.
constexpr std::array<std::string_view, 16> foreign_units{"m",  "m/s", "m/s^2", "m/s2", "m/s/s", "g",
                                                         "mg", "T",   "uT",    "N",    "Nm",    "V",
                                                         "A",  "%",   "Hz",    "Pa"};

std::string_view without_brackets(std::string_view unit) {
  const bool is_bracketed = unit.size() > 2 && (unit.front() == '[' || unit.front() == '(');
  return is_bracketed ? unit.substr(1, unit.size() - 2) : unit;
}

/// Reads the unit that begins at `at`, if there is one: "deg per s", "rad / s", "rev / min", "ms".
/// Returns its number of words.
std::size_t take_unit(std::span<const std::string> words, std::size_t at, StatedUnit& unit) {
  if (std::ranges::find(unread_words, words[at]) != unread_words.end()) {
    unit.unread = words[at];
    return 1;
  }
  const auto angle = std::ranges::find(angle_words, words[at], &RateWord::word);
  if (angle != angle_words.end()) {
    const bool contradicts = unit.rate && name_of(*unit.rate).option != name_of(angle->unit).option;
    if (contradicts) unit.unread = fmt::format("{} and {}", name_of(*unit.rate).option, words[at]);
    unit.rate = angle->unit;
    const std::size_t next = at + 1 < words.size() && words[at + 1] == "per" ? at + 2 : at + 1;
    constexpr std::array<std::string_view, 6> per_second{"adc",   "dps", "degps",
                                                         "radps", "rps", "rpm"};
    const bool is_a_minute = next < words.size() && words[next] == "min";
    if (is_a_minute && angle->unit == RateUnit::rev_s) unit.rate = RateUnit::rpm;
    if (is_a_minute && angle->unit != RateUnit::rev_s) unit.unread = words[at] + "/min";
    const bool has_time = is_a_minute || time_at(words, next) == TimeUnit::s;
    unit.is_per_second = has_time || std::ranges::find(per_second, words[at]) != per_second.end();
    return has_time ? next + 1 - at : 1;
  }
  if (const auto time = time_at(words, at)) {
    unit.time = time;
    return 1;
  }
  return 0;
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  const std::string plain = with_plain_letters(name);
  std::vector<std::string> words;
  std::string word;
  char before = ' ';
  for (const char c : plain) {
    const bool is_part = is_alpha(c) || is_numeral(c);
    if (!is_part || (!word.empty() && is_boundary(before, c)))
      add_word(words, std::exchange(word, {}));
    if (is_part) word += in_lower_case(c);
    before = c;
  }
  add_word(words, word);
  return words;
}

StatedUnit stated_unit(const std::vector<std::string>& words) {
  StatedUnit unit;
  for (std::size_t i = 0; i < words.size();) {
    const std::size_t taken = take_unit(words, i, unit);
    unit.ends_with_time = taken == 1 && i + 1 == words.size() && time_at(words, i);
    if (taken == 0) unit.other_words.push_back(words[i]);
    i += std::max<std::size_t>(taken, 1);
  }
  return unit;
}

std::optional<RateUnit> unit_in_preamble(const table::Header& header) {
  for (const std::string& line : header.preamble) {
    const std::vector<std::string> words = words_of(line);
    if (words == std::vector<std::string>{"in", "degrees", "yes"}) return RateUnit::deg_s;
    if (words == std::vector<std::string>{"in", "degrees", "no"}) return RateUnit::rad_s;
  }
  return std::nullopt;
}

StatedUnit stated_unit(const table::Header& header, std::size_t column) {
  StatedUnit unit = stated_unit(words_of(header.names[column]));
  if (header.calendar_of(column) != table::Calendar::none) unit.time = TimeUnit::s;
  if (column >= header.units.size()) return unit;
  // The cell contains only a unit; after the word "time", "min" and "h" count as well.
  std::vector<std::string> words = words_of(header.units[column]);
  words.insert(words.begin(), "time");
  const StatedUnit below = stated_unit(words);
  if (below.rate && unit.rate && *below.rate != *unit.rate) {
    unit.unread = fmt::format("{} by its name and in {} by its unit", name_of(*unit.rate).option,
                              header.units[column]);
  }
  if (below.rate) unit.rate = below.rate;
  unit.is_per_second = unit.is_per_second || below.is_per_second;
  if (below.time) unit.time = below.time;
  unit.ends_with_time = unit.ends_with_time || (below.time && !below.rate);
  if (!below.unread.empty()) unit.unread = below.unread;
  const std::string_view cell = without_brackets(header.units[column]);
  if (std::ranges::find(foreign_units, cell) != foreign_units.end()) unit.unread = cell;
  return unit;
}

}  // namespace twrench::recording
