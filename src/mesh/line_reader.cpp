#include "mesh/line_reader.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace twrench::mesh {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  return text.size() <= longest ? fmt::format("'{}'", text)
                                : fmt::format("'{}...'", text.substr(0, longest));
}

bool LineReader::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++line_number_;
  return true;
}

std::string_view LineReader::word() {
  std::size_t begin = 0;
  while (begin < line_.size() && is_blank(line_[begin])) ++begin;
  std::size_t end = begin;
  while (end < line_.size() && !is_blank(line_[end])) ++end;
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

std::string LineReader::place(std::size_t line_number) const {
  return fmt::format("{}:{}", name_, line_number);
}

}  // namespace twrench::mesh
