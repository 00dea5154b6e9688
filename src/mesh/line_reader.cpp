#include "mesh/line_reader.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace twrench::mesh {
namespace {

/// Line ends separate the words of a statement that continues over several lines.
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool is_continued(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line.ends_with('\\') && line.find('#') == std::string_view::npos;
}

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  return text.size() <= longest ? fmt::format("'{}'", text)
                                : fmt::format("'{}...'", text.substr(0, longest));
}

LineReader::LineReader(std::string name, std::string_view text)
    : name_(std::move(name)),
      line_end_(text.find('\n') == std::string_view::npos ? '\r' : '\n'),
      is_last_line_open_(!text.ends_with(line_end_)),
      rest_(text) {}

bool LineReader::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find(line_end_), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  line_number_ = ++lines_read_;
  return true;
}

bool LineReader::next_statement() {
  if (!next()) return false;
  const char* const begin = line_.data();
  const std::size_t first_number = line_number_;
  while (is_continued(line_) && next()) {
  }
  line_ = {begin, static_cast<std::size_t>(line_.data() + line_.size() - begin)};
  line_ = line_.substr(0, line_.find('#'));
  line_number_ = first_number;
  return true;
}

/// Returns whether the character is a backslash before a line end.
bool LineReader::is_continuation(std::size_t index) const {
  if (line_[index] != '\\') return false;
  return index + 1 == line_.size() || line_[index + 1] == '\r' || line_[index + 1] == '\n';
}

std::string_view LineReader::word() {
  std::size_t begin = 0;
  const auto separates = [&](std::size_t i) { return is_blank(line_[i]) || is_continuation(i); };
  while (begin < line_.size() && separates(begin)) ++begin;
  std::size_t end = begin;
  while (end < line_.size() && !separates(end)) ++end;
  const std::string_view word = line_.substr(begin, end - begin);
  line_.remove_prefix(end);
  return word;
}

double LineReader::number() {
  const std::string_view text = word();
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0.0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (text.empty()) throw bad("a number is missing");
  if (error == std::errc::invalid_argument || stop != digits.data() + digits.size()) {
    throw bad(fmt::format("{} is no number", shown(text)));
  }
  if (error == std::errc() && std::isfinite(value)) return value;
  throw InvalidArgument(place(), fmt::format("{} is not a finite number", shown(text)));
}

std::string LineReader::note_on_end() const {
  if (!rest_.empty() || !is_last_line_open_) return {};
  return "; the file ends in this line, so it is probably cut off";
}

std::string LineReader::place(std::size_t line_number) const {
  return fmt::format("{}:{}", name_, line_number);
}

}  // namespace twrench::mesh
