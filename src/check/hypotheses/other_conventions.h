#pragma once

#include <vector>

#include "recording/conventions/convention.h"
#include "table/reader.h"

namespace twrench::check {

/// The ways to read the columns of an attitude: first as `convention` says, then with another order
/// of the quaternion's components or of the rotations of Euler angles, in the other unit of angles,
/// and as the inverse, each alone and together; and with the wrong sign of one component of the
/// quaternion.
std::vector<recording::Convention> attitude_readings(const recording::Convention& convention);

/// A unit of times with a unit of rates.
struct Units {
  recording::TimeUnit time;
  recording::RateUnit rate;
};

/// The units that times and rates may have; those of the convention come first. Dates, and times
/// from several columns, have only that of the convention.
std::vector<Units> unit_readings(const table::Header& header,
                                 const recording::Convention& convention);

/// The number of aspects in which the conventions differ. A unit that the file states counts twice.
int count_changes(const recording::Convention& before, const recording::Convention& after);

}  // namespace twrench::check
