#include "fault_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "dice.h"

namespace twrench::torture {
namespace {

const std::map<std::string, int>& error_numbers() {
  static const std::map<std::string, int> numbers{
      {"EACCES", EACCES}, {"EAGAIN", EAGAIN}, {"ECHILD", ECHILD}, {"EDQUOT", EDQUOT},
      {"EINTR", EINTR},   {"EINVAL", EINVAL}, {"EIO", EIO},       {"EMFILE", EMFILE},
      {"ENFILE", ENFILE}, {"ENOLCK", ENOLCK}, {"ENOMEM", ENOMEM}, {"ENOSPC", ENOSPC},
      {"EROFS", EROFS},   {"EXDEV", EXDEV}};
  return numbers;
}

/// The errors with which the calls of each kind may fail, from their manual pages. EINTR never
/// occurs for ever, because a call is retried after it.
const std::map<std::string, std::vector<std::string>>& errors_of_kinds() {
  static const std::map<std::string, std::vector<std::string>> errors{
      {"open", {"EACCES", "EMFILE", "ENOSPC", "EIO", "ENOMEM"}},
      {"read", {"EIO", "EINTR"}},
      {"write", {"ENOSPC", "EIO", "EDQUOT", "EINTR"}},
      {"rename", {"EIO", "ENOSPC", "EACCES", "EXDEV"}},
      {"fsync", {"EIO", "ENOSPC", "EINVAL"}},
      {"close", {"EIO", "ENOSPC", "EINTR"}},
      {"pipe", {"EMFILE", "ENFILE"}},
      {"spawn", {"EAGAIN", "ENOMEM", "EACCES"}},
      {"wait", {"EINTR", "ECHILD"}},
      {"poll", {"EINTR", "ENOMEM"}},
      {"mmap", {"ENOMEM"}},
      {"opendir", {"EACCES", "EMFILE", "ENOMEM", "EIO"}},
      {"mkdir", {"EACCES", "ENOSPC", "EROFS"}},
      {"thread", {"EAGAIN"}},
      {"stat", {"EACCES", "EIO", "ENOMEM"}},
      {"fcntl", {"EINVAL", "ENOLCK", "EINTR"}},
      {"memory", {"ENOMEM"}}};
  return errors;
}

/// All ways in which a call may fail.
std::vector<FaultPoint> ways_to_fail(FaultPoint point, Dice& dice) {
  std::vector<FaultPoint> ways;
  for (const std::string& error : errors_of_kinds().at(point.kind)) {
    point.error = error;
    for (const bool always : {false, true}) {
      point.always = always;
      if (!always || error != "EINTR") ways.push_back(point);
    }
  }
  dice.shuffle(ways);
  return ways;
}

std::vector<FaultPoint> points_of_system_calls(const std::vector<CallCounts>& counts, Dice& dice) {
  std::vector<std::vector<FaultPoint>> rounds;
  for (const CallCounts& scenario : counts) {
    for (const auto& [kind, calls] : scenario.calls) {
      for (long number = 1; kind != "memory" && number <= calls; ++number) {
        const auto ways = ways_to_fail({scenario.scenario, kind, number, {}, false}, dice);
        rounds.resize(std::max(rounds.size(), ways.size()));
        for (std::size_t i = 0; i < ways.size(); ++i) rounds[i].push_back(ways[i]);
      }
    }
  }
  std::vector<FaultPoint> points;
  for (auto& round : rounds) {
    dice.shuffle(round);
    points.insert(points.end(), round.begin(), round.end());
  }
  return points;
}

std::vector<FaultPoint> points_of_memory(const std::vector<CallCounts>& counts, Dice& dice) {
  std::vector<FaultPoint> points;
  for (const CallCounts& scenario : counts) {
    const long calls = scenario.calls.at("memory");
    std::vector<long> numbers;
    for (long number = 1; number <= calls; ++number) numbers.push_back(number);
    dice.shuffle(numbers);
    numbers.resize(static_cast<std::size_t>(std::min(calls, scenario.memory_points)));
    for (const long number : numbers) {
      points.push_back({scenario.scenario, "memory", number, "ENOMEM", dice.chance(0.5)});
    }
  }
  dice.shuffle(points);
  return points;
}

}  // namespace

std::string FaultPoint::text() const {
  return fmt::format("{}/{}/{}/{}/{}", scenario, kind, number, error, always ? "always" : "once");
}

std::string FaultPoint::order() const {
  return fmt::format("{}:{}:{}:{}", kind, number, error_numbers().at(error),
                     always ? "always" : "once");
}

FaultPoint parse_fault_point(const std::string& text) {
  static const std::regex form("([a-z-]+)/([a-z]+)/([0-9]{1,15})/([A-Z]+)/(once|always)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form) || !errors_of_kinds().contains(parts[2]) ||
      !error_numbers().contains(parts[4])) {
    throw std::invalid_argument("a case is SCENARIO/KIND/NUMBER/ERRNO/once|always, not " + text);
  }
  return {parts[1], parts[2], std::stol(parts[3]), parts[4], parts[5] == "always"};
}

std::map<std::string, long> read_call_counts(const std::string& log) {
  std::map<std::string, long> counts;
  std::istringstream words(log);
  for (std::string word, kind; words >> word;) {
    if (word == "count" && words >> kind) words >> counts[kind];
  }
  return counts;
}

std::vector<FaultPoint> all_fault_points(const std::vector<CallCounts>& counts,
                                         std::uint32_t seed) {
  Dice dice(seed, 0);
  const auto calls = points_of_system_calls(counts, dice);
  const auto memory = points_of_memory(counts, dice);
  std::vector<FaultPoint> points;
  for (std::size_t i = 0, m = 0; i < calls.size() || m < memory.size(); ++i) {
    if (i < calls.size()) points.push_back(calls[i]);
    // Memory points are more numerous, and most take less time.
    for (int n = 0; n < 2 && m < memory.size(); ++n) points.push_back(memory[m++]);
  }
  return points;
}

}  // namespace twrench::torture
