#pragma once

#include <vector>

#include "check/conventions/convention.h"
#include "table/reader.h"

namespace twrench::check {

/// The ways in which the columns of an attitude can be read: as they are first, then with another
/// order of the quaternion's components or of the rotations of Euler angles, in the other unit of
/// Euler angles unless the columns state theirs, and as the inverse, each alone and together.
std::vector<Convention> attitude_readings(const table::Header& header,
                                          const Convention& convention);

/// A unit of times with a unit of rates.
struct Units {
  TimeUnit time;
  RateUnit rate;
};

/// The units in which times and rates may be that do not state theirs, those of the convention
/// first.
std::vector<Units> unit_readings(const table::Header& header, const Convention& convention);

/// In how many aspects the conventions differ.
int count_changes(const Convention& before, const Convention& after);

}  // namespace twrench::check
