#include "recording/conventions/convention.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/enumeration.h"
#include "base/words.h"
#include "recording/conventions/names.h"
#include "recording/conventions/units.h"

namespace twrench::recording {
namespace {

using Get = FieldValue (*)(const Convention&);
using Statement = std::string (*)(const Convention&);

const std::string& word_in(const FieldValue& value) { return std::get<std::string>(value); }

/// A field with a unit.
template <typename Name>
Field unit_field(const char* name, const char* help, const char* otherwise,
                 std::span<const Name> units, std::optional<decltype(Name::unit)> Convention::*unit,
                 Get value, Statement statement) {
  std::vector<std::string> words;
  for (const Name& one : units) words.emplace_back(one.option);
  const auto set = [=](Convention& c, const FieldValue& given) {
    const auto found = std::ranges::find(units, word_in(given), &Name::option);
    if (found == units.end()) throw unknown_name(argument(name), word_in(given), words);
    c.*unit = found->unit;
  };
  return {name,
          FieldForm::text,
          fmt::format("{}: {}", help, fmt::join(words, ", ")),
          "UNIT",
          otherwise,
          words,
          value,
          set,
          statement};
}

Field columns_field() {
  return {"columns",
          FieldForm::text,
          "the file's columns for t, wx wy wz, lx ly lz, x11 to x33, qw qx qy qz, yaw pitch roll, "
          "rvx rvy rvz, axisx axisy axisz angle, mrpx mrpy mrpz, gibbsx gibbsy gibbsz",
          "t=NAME,wx=NAME,...",
          "by their names",
          {},
          [](const Convention& c) { return FieldValue(c.columns); },
          [](Convention& c, const FieldValue& value) {
            c.columns = parse_columns(word_in(value), argument("columns"));
          },
          [](const Convention&) { return std::string("the columns have another order"); }};
}

Field sequence_field() {
  return {"sequence",
          FieldForm::text,
          "axes of Euler angles in the order of the rotations",
          "AXES",
          "",
          {},
          [](const Convention& c) { return FieldValue(c.sequence); },
          [](Convention& c, const FieldValue& value) {
            c.sequence = parse_sequence(word_in(value), argument("sequence"));
          },
          [](const Convention& c) {
            return fmt::format("the angles turn about {}, then {}, then {}", c.sequence[0],
                               c.sequence[1], c.sequence[2]);
          }};
}

Field negated_field() {
  return {"negated",
          FieldForm::unasked,
          "",
          "",
          "",
          {},
          [](const Convention& c) { return FieldValue(c.negated); },
          nullptr,
          [](const Convention& c) { return c.columns.at(c.negated) + " has the wrong sign"; }};
}

Field inverse_field() {
  return {"inverse",
          FieldForm::flag,
          "the attitude is body from space, not space from body",
          "",
          "",
          {},
          [](const Convention& c) { return FieldValue(c.inverse); },
          [](Convention& c, const FieldValue& value) { c.inverse = std::get<bool>(value); },
          [](const Convention& c) {
            return std::string("the attitude is ") +
                   (c.inverse ? "body from space" : "space from body");
          }};
}

Field rates_field() {
  static const std::vector<std::string> words{"body", "space"};
  return {"rates",
          FieldForm::text,
          "the axes of the rates: body or space",
          "AXES",
          "body",
          words,
          [](const Convention& c) { return FieldValue(words[c.rates_in_space ? 1 : 0]); },
          [](Convention& c, const FieldValue& value) {
            c.rates_in_space = word_in(value) == "space";
            if (std::ranges::find(words, word_in(value)) == words.end()) {
              throw unknown_name(argument("rates"), word_in(value), words);
            }
          },
          [](const Convention& c) {
            return std::string("the rates are in ") +
                   (c.rates_in_space ? "space axes" : "the body's axes");
          }};
}

Field axes_field() {
  return {
      "axes",
      FieldForm::text,
      "the body's axes along which the file's x, y and z point, such as x,-z,y",
      "X,Y,Z",
      "x,y,z",
      {},
      [](const Convention& c) { return FieldValue(format_body_axes(c.axes)); },
      [](Convention& c, const FieldValue& value) {
        c.axes = parse_body_axes(word_in(value), argument("axes"));
      },
      [](const Convention& c) { return "its axes are the body's " + format_body_axes(c.axes); }};
}

Field offset_field() {
  return {"offset",
          FieldForm::rotation,
          "the attitude is that of a part: the quaternion, scalar first, that takes its axes to "
          "the body's",
          "W,X,Y,Z",
          "",
          {},
          [](const Convention& c) { return c.offset ? FieldValue(*c.offset) : FieldValue(); },
          [](Convention& c, const FieldValue& value) {
            c.offset = std::get<Eigen::Quaterniond>(value);
          },
          [](const Convention& c) {
            return std::string("the attitude is ") +
                   (c.offset ? "that of a part that is turned in the body" : "the body's own");
          }};
}

std::vector<Field> all_fields() {
  return {
      columns_field(),
      unit_field(
          "time_unit", "unit of times", "what the file says, else s", units_of_times(),
          &Convention::time_unit,
          [](const Convention& c) { return FieldValue(name_of(time_unit(c)).option); },
          [](const Convention& c) {
            return c.columns.at("t") + " is in " + name_of(time_unit(c)).option;
          }),
      unit_field(
          "units", "unit of angles and, a second, of rates; rpm of rates alone",
          "what the file says, else rad", units_of_rates(), &Convention::rate_unit,
          [](const Convention& c) { return FieldValue(name_of(rate_unit(c)).option); },
          [](const Convention& c) {
            return std::string("the rates are in ") + name_of(rate_unit(c)).symbol;
          }),
      unit_field(
          "angle_units", "unit of Euler angles alone", "what the file says, else that of the rates",
          units_of_angles(), &Convention::angle_unit,
          [](const Convention& c) {
            const bool has_unit = has_angles(attitude_form(c));
            return FieldValue(has_unit ? name_of(angle_unit(c)).option : "");
          },
          [](const Convention& c) {
            return std::string("the angles are in ") + name_of(angle_unit(c)).option;
          }),
      sequence_field(),
      negated_field(),
      inverse_field(),
      rates_field(),
      axes_field(),
      offset_field()};
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

const std::vector<Field>& convention_fields() {
  static const std::vector<Field> fields = all_fields();
  return fields;
}

bool agree(const Field& field, const Convention& a, const Convention& b) {
  const FieldValue of_a = field.value(a), of_b = field.value(b);
  const auto* p = std::get_if<Eigen::Quaterniond>(&of_a);
  const auto* q = std::get_if<Eigen::Quaterniond>(&of_b);
  if (p == nullptr || q == nullptr) return of_a == of_b;
  constexpr double rounding = 1e-9;  // rad
  return p->angularDistance(*q) < rounding;
}

std::string mention(const Field& field, const Convention& convention) {
  const FieldValue value = field.value(convention);
  switch (field.form) {
    case FieldForm::unasked:
      return {};
    case FieldForm::flag:
      return std::get<bool>(value) ? argument(field.name) : std::string();
    case FieldForm::rotation:
      if (const auto* q = std::get_if<Eigen::Quaterniond>(&value)) {
        return argument(field.name, fmt::format("{:.15g},{:.15g},{:.15g},{:.15g}", q->w(), q->x(),
                                                q->y(), q->z()));
      }
      return {};
    case FieldForm::text:
      break;
  }
  if (const auto* columns = std::get_if<std::map<std::string, std::string>>(&value)) {
    return argument(field.name, format_columns(*columns));
  }
  const auto& word = std::get<std::string>(value);
  return word.empty() ? std::string() : argument(field.name, word);
}

bool contradicts_file(const Convention& before, const Convention& after) {
  return std::ranges::any_of(convention_fields(), [&](const Field& field) {
    return before.stated_units.contains(field.name) && !agree(field, before, after);
  });
}

std::string changing_arguments(const Convention& before, const Convention& after) {
  std::vector<std::string> mentions;
  // The unit of rates is that of angles, too, unless these have their own.
  Convention with_units = before;
  const bool is_stated = before.stated_units.contains("units");
  if (!is_stated && rate_unit(after) != rate_unit(before)) with_units.rate_unit = rate_unit(after);
  for (const Field& field : convention_fields()) {
    if (before.stated_units.contains(field.name)) continue;
    const bool is_angle = field.name == std::string_view("angle_units");
    const std::string text = mention(field, after);
    if (!text.empty() && !agree(field, is_angle ? with_units : before, after)) {
      mentions.push_back(text);
    }
  }
  return fmt::format("{}", fmt::join(mentions, " "));
}

}  // namespace twrench::recording
