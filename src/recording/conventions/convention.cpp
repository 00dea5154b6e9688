#include "recording/conventions/convention.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/enumeration.h"
#include "base/letters.h"
#include "base/nearest.h"
#include "recording/conventions/names.h"
#include "recording/conventions/units.h"

namespace twrench::recording {
namespace {

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

TimeUnit time_unit(const Convention& convention) {
  return convention.time_unit.value_or(TimeUnit::s);
}

RateUnit rate_unit(const Convention& convention) {
  return convention.rate_unit.value_or(RateUnit::rad_s);
}

Angle angle_unit(const Convention& convention) {
  if (convention.angle_unit) return *convention.angle_unit;
  return angle_of(rate_unit(convention)).value_or(Angle::radians);
}

std::optional<Kind> kind_of(AttitudeForm form) {
  switch (form) {
    case AttitudeForm::none:
      return std::nullopt;
    case AttitudeForm::matrix:
      return Kind::matrix;
    case AttitudeForm::quaternion:
      return Kind::quaternion;
    case AttitudeForm::euler:
      return Kind::euler;
    case AttitudeForm::rotation_vector:
      return Kind::rotation_vector;
    case AttitudeForm::axis_angle:
      return Kind::axis_angle;
    case AttitudeForm::mrp:
      return Kind::mrp;
    case AttitudeForm::rodrigues:
      return Kind::rodrigues;
  }
  return std::nullopt;
}

AttitudeForm attitude_form(const Convention& convention) {
  for (const AttitudeForm form : enumerators<AttitudeForm>) {
    const auto kind = kind_of(form);
    if (kind && convention.columns.contains(names_of(*kind).front())) return form;
  }
  return AttitudeForm::none;
}

bool has_angles(AttitudeForm form) {
  switch (form) {
    case AttitudeForm::euler:
    case AttitudeForm::rotation_vector:
    case AttitudeForm::axis_angle:
      return true;
    case AttitudeForm::none:
    case AttitudeForm::matrix:
    case AttitudeForm::quaternion:
    case AttitudeForm::mrp:
    case AttitudeForm::rodrigues:
      break;
  }
  return false;
}

bool has_momentum(const Convention& convention) { return convention.columns.contains("lx"); }

bool has_rates(const Convention& convention) {
  return convention.columns.contains("wx") || has_momentum(convention);
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

const std::vector<std::string>& all_sequences() {
  static const std::vector<std::string> sequences{"zyx", "zxy", "yxz", "yzx", "xyz", "xzy",
                                                  "zxz", "zyz", "yxy", "yzy", "xyx", "xzx"};
  return sequences;
}

std::string parse_sequence(std::string_view text, const std::string& quantity) {
  std::string small = to_lower(text);
  if (std::ranges::find(all_sequences(), small) != all_sequences().end()) return small;
  throw unknown_name(quantity, text, all_sequences());
}

}  // namespace twrench::recording
