#include "recording/columns/stated_rate.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "recording/columns/stated_unit.h"
#include "recording/columns/word_lists.h"

namespace twrench::recording {
namespace {

/// A number of a line, and the words between it and the number before.
struct NumberWithWords {
  Words words;
  double number = 0;
};

std::vector<NumberWithWords> numbers_in(std::string_view line) {
  constexpr std::string_view digits = "0123456789";
  std::vector<NumberWithWords> found;
  std::size_t begin = 0;
  for (std::size_t at = line.find_first_of(digits); at != std::string_view::npos;) {
    double number = 0;
    const auto read = std::from_chars(line.data() + at, line.data() + line.size(), number);
    found.push_back({words_of(line.substr(begin, at - begin)), number});
    begin = static_cast<std::size_t>(read.ptr - line.data());
    at = line.find_first_of(digits, begin);
  }
  // The unit behind a number does not name the next one.
  for (std::size_t i = 1; i < found.size(); ++i) {
    Words& words = found[i].words;
    if (!words.empty() && is_in({"hz", "fps", "s"}, words.front())) words.erase(words.begin());
  }
  return found;
}

/// The rate that the number is by the words before it.
std::optional<double> rate_of(const NumberWithWords& one) {
  const bool is_rate = has_any(
      one.words, {"rate", "fps", "frequency", "freq", "framerate", "datarate", "samplerate"});
  const bool is_interval = has_any(one.words, {"time", "interval", "period"}) &&
                           has_any(one.words, {"frame", "sample", "sampling"});
  const bool is_known = has_only(
      one.words,
      {"rate",     "fps",    "frequency", "freq",    "framerate", "datarate",    "samplerate",
       "frame",    "data",   "update",    "sample",  "sampling",  "output",      "capture",
       "export",   "camera", "video",     "logging", "log",       "acquisition", "time",
       "interval", "period", "hz",        "is",      "of",        "the",         "s",
       "sec",      "in",     "per",       "second",  "seconds",   "imu",         "recording"});
  if (!is_known || is_rate == is_interval || one.number <= 0) return std::nullopt;
  return is_rate ? one.number : 1 / one.number;
}

}  // namespace

std::optional<double> stated_rate(const table::Header& header) {
  std::vector<double> rates, exported;
  for (const std::string& line : header.preamble) {
    for (const NumberWithWords& one : numbers_in(line)) {
      const auto rate = rate_of(one);
      if (!rate) continue;
      rates.push_back(*rate);
      if (has_any(one.words, {"export", "output"})) exported.push_back(*rate);
    }
  }
  if (!exported.empty()) rates = exported;
  const bool is_single = !rates.empty() && std::ranges::count(rates, rates.front()) ==
                                               static_cast<std::ptrdiff_t>(rates.size());
  if (is_single) return rates.front();
  // Vicon has the rate alone on a line, and numbers samples between frames.
  const bool has_sub_frames = std::ranges::any_of(header.names, [](const std::string& name) {
    return words_of(name) == Words{"sub", "frame"};
  });
  if (!rates.empty() || !has_sub_frames) return std::nullopt;
  for (const std::string& line : header.preamble) {
    const auto numbers = numbers_in(line);
    const bool is_alone = numbers.size() == 1 && numbers.front().words.empty() &&
                          words_of(line).size() <= 2 && numbers.front().number > 0;
    if (is_alone) return numbers.front().number;
  }
  return std::nullopt;
}

}  // namespace twrench::recording
