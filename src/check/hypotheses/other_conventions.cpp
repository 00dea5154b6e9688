#include "check/hypotheses/other_conventions.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "recording/columns/columns.h"
#include "recording/conventions/convention.h"
#include "recording/conventions/units.h"

namespace twrench::check {
namespace {

using recording::Angle;
using recording::AttitudeForm;
using recording::Convention;

/// Adds a changed copy of each convention in the list.
template <typename Change>
void also(std::vector<Convention>& list, const Change& change) {
  const std::size_t count = list.size();
  for (std::size_t i = 0; i < count; ++i) {
    Convention changed = list[i];
    change(changed);
    list.push_back(std::move(changed));
  }
}

/// Reads the columns of (w, x, y, z) as (x, y, z, w).
void scalar_first_to_last(Convention& convention) {
  auto& columns = convention.columns;
  const std::string first = columns["qw"];
  columns["qw"] = columns["qz"];
  columns["qz"] = columns["qy"];
  columns["qy"] = columns["qx"];
  columns["qx"] = first;
}

void scalar_last_to_first(Convention& convention) {
  for (int i = 0; i < 3; ++i) scalar_first_to_last(convention);
}

void add_quaternion_orders(std::vector<Convention>& list) {
  const std::vector<Convention> as_given = list;
  for (const auto& reorder : {scalar_first_to_last, scalar_last_to_first}) {
    for (Convention changed : as_given) {
      reorder(changed);
      list.push_back(std::move(changed));
    }
  }
}

void add_negated_components(std::vector<Convention>& list) {
  const std::vector<Convention> as_given = list;
  for (const char* component : {"qx", "qy", "qz"}) {
    for (Convention changed : as_given) {
      changed.negated = component;
      list.push_back(std::move(changed));
    }
  }
}

void add_sequences(std::vector<Convention>& list) {
  const std::vector<Convention> as_given = list;
  for (const std::string& sequence : recording::all_sequences()) {
    for (Convention changed : as_given) {
      if (changed.sequence == sequence) continue;
      changed.sequence = sequence;
      list.push_back(std::move(changed));
    }
  }
}

Angle other(Angle unit) { return unit == Angle::radians ? Angle::degrees : Angle::radians; }

void add_angle_units(std::vector<Convention>& list) {
  also(list, [](Convention& c) { c.angle_unit = other(angle_unit(c)); });
}

/// Whether the times are dates, or were computed from several columns.
bool has_certain_times(const table::Header& header, const Convention& convention) {
  const std::size_t column = recording::find_column(header, "t", convention.columns.at("t"));
  return header.calendar_of(column) != table::Calendar::none || !header.sources_of(column).empty();
}

}  // namespace

std::vector<Convention> attitude_readings(const Convention& convention) {
  std::vector<Convention> list{convention}, with_negated;
  // The unit of rates, which is tried apart, does not change that of angles.
  list.front().angle_unit = angle_unit(convention);
  switch (attitude_form(convention)) {
    case AttitudeForm::none:
      return list;
    case AttitudeForm::matrix:
    case AttitudeForm::mrp:
    case AttitudeForm::rodrigues:
      break;
    case AttitudeForm::quaternion:
      add_quaternion_orders(list);
      with_negated = list;
      add_negated_components(with_negated);
      with_negated.erase(with_negated.begin(), with_negated.begin() + std::ssize(list));
      break;
    case AttitudeForm::euler:
      add_sequences(list);
      add_angle_units(list);
      break;
    case AttitudeForm::rotation_vector:
      add_angle_units(list);
      break;
    case AttitudeForm::axis_angle:
      add_angle_units(list);
      break;
  }
  also(list, [](Convention& c) { c.inverse = !c.inverse; });
  // Last, because without rates a component with the wrong sign is the same motion as the inverse.
  list.insert(list.end(), with_negated.begin(), with_negated.end());
  return list;
}

std::vector<Units> unit_readings(const table::Header& header, const Convention& convention) {
  const Units as_read{time_unit(convention), rate_unit(convention)};
  std::vector<recording::TimeUnit> times{as_read.time};
  if (!has_certain_times(header, convention)) {
    for (const recording::TimeUnitName& name : recording::common_units_of_times()) {
      if (name.unit != as_read.time) times.push_back(name.unit);
    }
  }
  std::vector<recording::RateUnit> rates{as_read.rate};
  if (has_rates(convention) && !has_momentum(convention)) {
    for (const recording::RateUnitName& name : recording::units_of_rates()) {
      if (name.unit != as_read.rate) rates.push_back(name.unit);
    }
  }
  std::vector<Units> all;
  for (const recording::TimeUnit time : times) {
    for (const recording::RateUnit rate : rates) all.push_back({time, rate});
  }
  return all;
}

int count_changes(const Convention& before, const Convention& after) {
  int count = 0;
  for (const recording::Field& field : recording::convention_fields()) {
    if (!agree(field, before, after)) count += before.stated_units.contains(field.name) ? 2 : 1;
  }
  return count;
}

}  // namespace twrench::check
