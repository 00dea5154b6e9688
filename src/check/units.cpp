#include "check/units.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <utility>

namespace twrench::check {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array<Pair, 9> letters{{{"\u03c9", "omega"},
                                       {"\u03a9", "omega"},
                                       {"\u03c6", "phi"},
                                       {"\u03d5", "phi"},
                                       {"\u03b8", "theta"},
                                       {"\u03c8", "psi"},
                                       {"\u00b0", " deg "},
                                       {"\u00b5", "u"},
                                       {"\u03bc", "u"}}};

/// Words that stand before a component without anything between them: "qw", "omegax".
constexpr std::array<std::string_view, 7> prefixes{"w", "omega", "gyro",  "rate",
                                                   "q", "quat",  "angvel"};

// Not those of <cctype>, which depend on the locale.
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

/// Adds a word, or the two that it is put together from.
void add_word(std::vector<std::string>& words, std::string word) {
  if (word.empty()) return;
  const std::string stem = word.substr(0, word.size() - 1);
  const bool has_axis = std::string_view("wxyz").find(word.back()) != std::string_view::npos;
  if (has_axis && std::ranges::find(prefixes, stem) != prefixes.end()) {
    words.push_back(stem);
    words.emplace_back(1, word.back());
  } else {
    words.push_back(std::move(word));
  }
}

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

constexpr std::array<std::string_view, 6> degree_words{"deg",     "degs", "degree",
                                                       "degrees", "dps",  "degps"};
constexpr std::array<std::string_view, 5> radian_words{"rad", "rads", "radian", "radians", "radps"};
constexpr std::array<std::string_view, 8> unread_words{"rpm",   "rps",  "rev",    "revs",
                                                       "turns", "mrad", "cycles", "gon"};

constexpr std::array<std::pair<std::string_view, double>, 15> time_words{{{"s", 1},
                                                                          {"sec", 1},
                                                                          {"secs", 1},
                                                                          {"second", 1},
                                                                          {"seconds", 1},
                                                                          {"ms", 1e-3},
                                                                          {"msec", 1e-3},
                                                                          {"millis", 1e-3},
                                                                          {"milliseconds", 1e-3},
                                                                          {"us", 1e-6},
                                                                          {"usec", 1e-6},
                                                                          {"microseconds", 1e-6},
                                                                          {"ns", 1e-9},
                                                                          {"nsec", 1e-9},
                                                                          {"nanoseconds", 1e-9}}};

std::optional<double> seconds_in(std::string_view word) {
  const auto found =
      std::ranges::find(time_words, word, [](const auto& unit) { return unit.first; });
  if (found == time_words.end()) return std::nullopt;
  return found->second;
}

/// Takes the unit at the front of the words, if there is one: "deg per s", "rad / s", "ms". Returns
/// how many words it has.
std::size_t take_unit(std::span<const std::string> words, StatedUnit& unit) {
  const std::string& first = words.front();
  const auto is_second = [&](std::size_t i) {
    return i < words.size() && seconds_in(words[i]) == 1.0;
  };
  std::optional<Angle> angle;
  if (is_one_of(degree_words, first)) angle = Angle::degrees;
  if (is_one_of(radian_words, first)) angle = Angle::radians;
  if (is_one_of(unread_words, first)) {
    unit.unread = first;
    return 1;
  }
  if (angle) {
    unit.angle = angle;
    if (is_second(1)) return 2;
    return words.size() > 2 && words[1] == "per" && is_second(2) ? 3 : 1;
  }
  if (const auto seconds = seconds_in(first)) {
    unit.seconds = seconds;
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
    const std::size_t taken = take_unit(std::span(words).subspan(i), unit);
    if (taken == 0) unit.other_words.push_back(words[i]);
    i += std::max<std::size_t>(taken, 1);
  }
  return unit;
}

StatedUnit stated_unit(const table::Header& header, std::size_t column) {
  StatedUnit unit = stated_unit(words_of(header.names[column]));
  if (column >= header.units.size()) return unit;
  const StatedUnit below = stated_unit(words_of(header.units[column]));
  if (below.angle) unit.angle = below.angle;
  if (below.seconds) unit.seconds = below.seconds;
  if (!below.unread.empty()) unit.unread = below.unread;
  return unit;
}

const char* name_of(Angle unit) { return unit == Angle::radians ? "radians" : "degrees"; }

double radians_in(Angle unit) { return unit == Angle::radians ? 1.0 : std::numbers::pi / 180.0; }

}  // namespace twrench::check
