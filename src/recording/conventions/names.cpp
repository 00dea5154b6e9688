#include "recording/conventions/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "base/enumeration.h"
#include "base/words.h"

namespace twrench::recording {
namespace {

struct KindRow {
  Kind kind;
  const char* description;
  std::array<const char*, 9> names;  ///< null after the last
};

constexpr std::array kind_rows{
    KindRow{Kind::time, "the time", {"t"}},
    KindRow{Kind::rates, "the rates", {"wx", "wy", "wz"}},
    KindRow{Kind::momentum, "the angular momentum", {"lx", "ly", "lz"}},
    KindRow{Kind::matrix,
            "the matrix",
            {"x11", "x12", "x13", "x21", "x22", "x23", "x31", "x32", "x33"}},
    KindRow{Kind::quaternion, "the quaternion", {"qw", "qx", "qy", "qz"}},
    KindRow{Kind::euler, "the Euler angles", {"yaw", "pitch", "roll"}},
    KindRow{Kind::rotation_vector, "the rotation vector", {"rvx", "rvy", "rvz"}},
    KindRow{Kind::axis_angle, "the axis and angle", {"axisx", "axisy", "axisz", "angle"}},
    KindRow{Kind::mrp, "the modified Rodrigues parameters", {"mrpx", "mrpy", "mrpz"}},
    KindRow{Kind::rodrigues, "the Rodrigues parameters", {"gibbsx", "gibbsy", "gibbsz"}}};
static_assert(has_row_for_each(kind_rows, &KindRow::kind));

std::map<Kind, std::vector<std::string>> names_of_kinds() {
  std::map<Kind, std::vector<std::string>> names;
  for (const KindRow& row : kind_rows) {
    names[row.kind] = {row.names.begin(), std::ranges::find(row.names, nullptr)};
  }
  return names;
}

/// Takes the text up to the next unquoted `end`, without its quotes, and skips that `end`.
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
  static const std::map<Kind, std::vector<std::string>> names = names_of_kinds();
  return names.at(kind);
}

std::vector<std::string> all_names() {
  std::vector<std::string> all;
  for (const Kind kind : enumerators<Kind>)
    std::ranges::copy(names_of(kind), std::back_inserter(all));
  return all;
}

const char* description_of(Kind kind) {
  return std::ranges::find(kind_rows, kind, &KindRow::kind)->description;
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
    const std::string ours = to_lower(left);
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

}  // namespace twrench::recording
