#include "messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>

namespace twrench::torture {
namespace {

constexpr std::string_view error_begin = "twrench: error: ";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

bool is_utf8(const std::string& text) {
  try {
    static_cast<void>(nlohmann::json(text).dump());
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

/// C0, DEL and C1 (two bytes in UTF-8), except for line ends.
bool has_control_characters(const std::string& text, const std::string& allowed) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_c0 = byte < 0x20 && allowed.find(text[i]) == std::string::npos;
    const bool is_c1 =
        byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (is_c0 || is_c1 || byte == 0x7f) return true;
  }
  return false;
}

/// Whether it contains the word "nan", "inf" or "infinity".
bool has_not_a_number(const std::string& text) {
  std::string word;
  for (const char c : text + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (word == "nan" || word == "inf" || word == "infinity") return true;
    word.clear();
  }
  return false;
}

bool is_aside(const std::string& line) {
  return line.starts_with("twrench: note: ") || line.starts_with("twrench: warning: ");
}

/// Checks that there are only the error and its remedy.
void judge_error(const Ended& run, const Manner& manner, std::vector<std::string>& faults) {
  const std::vector<std::string> lines = lines_of(run.err);
  const auto is_error = [](const std::string& line) { return line.starts_with(error_begin); };
  const auto count = std::ranges::count_if(lines, is_error);
  const bool failed = run.code != 0 && run.code != 1;
  if (failed && count == 0 && manner.may_be_mute) return;
  if (count != (failed ? 1 : 0)) {
    faults.push_back(fmt::format("{} error lines with exit code {}", count, run.code));
    return;
  }
  if (!failed) return;
  const auto error = std::ranges::find_if(lines, is_error);
  const auto after = lines.end() - error - 1;
  if (after > 1 || (after == 1 && !lines.back().starts_with("  "))) {
    faults.emplace_back("more than a remedy after the error line");
  }
  if (!manner.has_progress && !std::all_of(lines.begin(), error, is_aside)) {
    faults.emplace_back("other lines before the error line");
  }
}

void judge_text(const std::string& text, const char* where, const std::string& allowed,
                std::vector<std::string>& faults) {
  if (!is_utf8(text)) faults.push_back(fmt::format("bytes that are no UTF-8 on {}", where));
  if (has_control_characters(text, allowed)) {
    faults.push_back(fmt::format("control characters on {}", where));
  }
}

}  // namespace

std::vector<std::string> faults_in_manner(const Ended& run, const Manner& manner) {
  std::vector<std::string> faults;
  if (run.was_killed) return {"it did not hear SIGTERM"};
  if (run.signal != 0) return {fmt::format("signal {} ended it", run.signal)};
  constexpr std::array documented{0, 1, 2, 3, 4, 5, 130, 143};
  const bool lacked_memory =
      run.code == 70 && manner.may_lack_memory &&
      (run.err.starts_with("twrench: error: memory: ") || manner.may_be_mute);
  if (!lacked_memory && std::ranges::find(documented, run.code) == documented.end()) {
    faults.push_back(fmt::format("exit code {}", run.code));
  }
  if (run.asked_to_stop && run.code != 0 && run.code != 143) {
    faults.push_back(fmt::format("exit code {} after SIGTERM", run.code));
  }
  judge_error(run, manner, faults);
  judge_text(run.err, "standard error", manner.has_bar ? "\n\r\x1b" : "\n", faults);
  if (manner.out_is_text) {
    judge_text(run.out, "standard output", "\n", faults);
    if (run.code == 0 && !manner.may_name_infinity && has_not_a_number(run.out)) {
      faults.emplace_back("a number that is none, with exit code 0");
    }
  }
  return faults;
}

}  // namespace twrench::torture
