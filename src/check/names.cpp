#include "check/names.h"

#include <fmt/format.h>
#include <twrench/base/nearest.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "base/letters.h"
#include "check/convention.h"

namespace twrench::check {
namespace {

std::vector<std::string> matrix_names() {
  std::vector<std::string> names;
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 3; ++j) names.push_back(fmt::format("x{}{}", i, j));
  }
  return names;
}

/// Takes the text up to the next `end` that is in no quotation marks, and that, too.
std::string take_until(std::string_view& text, char end) {
  std::string taken;
  bool quoted = false;
  while (!text.empty()) {
    const char c = text.front();
    text.remove_prefix(1);
    if (c == '"' && quoted && text.starts_with('"')) {
      taken += '"';
      text.remove_prefix(1);
    } else if (c == '"' && (quoted || taken.empty())) {
      quoted = !quoted;
    } else if (c == end && !quoted) {
      break;
    } else {
      taken += c;
    }
  }
  return taken;
}

std::string in_quotes_if_needed(const std::string& name) {
  const bool is_plain = !name.empty() && name.find_first_of(",=\"") == std::string::npos &&
                        name.front() != ' ' && name.back() != ' ';
  if (is_plain) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

const std::vector<std::string>& names_of(Kind kind) {
  static const std::array<std::vector<std::string>, all_kinds.size()> names{
      {{"t"},
       {"wx", "wy", "wz"},
       matrix_names(),
       {"qw", "qx", "qy", "qz"},
       {"yaw", "pitch", "roll"}}};
  return names.at(static_cast<std::size_t>(kind));
}

std::vector<std::string> all_names() {
  std::vector<std::string> all;
  for (const Kind kind : all_kinds) std::ranges::copy(names_of(kind), std::back_inserter(all));
  return all;
}

const char* description_of(Kind kind) {
  constexpr std::array descriptions{"the time", "the rates", "the matrix", "the quaternion",
                                    "the Euler angles"};
  return descriptions.at(static_cast<std::size_t>(kind));
}

std::map<std::string, std::string> parse_columns(std::string_view text,
                                                 const std::string& quantity) {
  const std::vector<std::string> known = all_names();
  std::map<std::string, std::string> columns;
  while (!text.empty()) {
    const std::size_t equals = text.find('=');
    const std::string_view left = text.substr(0, equals);
    if (equals == std::string_view::npos || left.find(',') != std::string_view::npos) {
      throw InvalidArgument(quantity,
                            fmt::format("'{}' has no '='", left.substr(0, left.find(','))),
                            "write our name = the file's name: t=time,wx=p,wy=q,wz=r");
    }
    const std::string ours = in_small_letters(left);
    if (std::ranges::find(known, ours) == known.end()) throw unknown_name(quantity, left, known);
    text.remove_prefix(equals + 1);
    const std::string theirs = take_until(text, ',');
    if (theirs.empty()) {
      throw InvalidArgument(quantity, fmt::format("'{}=' names no column", ours),
                            "name a column of the file, or #3 for its third");
    }
    if (!columns.emplace(ours, theirs).second) {
      throw InvalidArgument(quantity, fmt::format("'{}' is there twice", ours));
    }
  }
  return columns;
}

std::string format_columns(const std::map<std::string, std::string>& columns) {
  std::string text;
  for (const std::string& ours : all_names()) {
    const auto column = columns.find(ours);
    if (column == columns.end()) continue;
    if (!text.empty()) text += ',';
    text += ours + '=' + in_quotes_if_needed(column->second);
  }
  return text;
}

const std::vector<std::string>& all_sequences() {
  static const std::vector<std::string> sequences{"zyx", "zxy", "yxz", "yzx", "xyz", "xzy",
                                                  "zxz", "zyz", "yxy", "yzy", "xyx", "xzx"};
  return sequences;
}

std::string parse_sequence(std::string_view text, const std::string& quantity) {
  std::string small = in_small_letters(text);
  if (std::ranges::find(all_sequences(), small) != all_sequences().end()) return small;
  throw unknown_name(quantity, text, all_sequences());
}

}  // namespace twrench::check
