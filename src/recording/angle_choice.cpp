#include "recording/angle_choice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "recording/columns/columns.h"
#include "recording/conventions/names.h"
#include "table/error.h"

namespace twrench::recording {
namespace {

/// Whether an angle of the first rows exceeds a turn in radians. Cells that are no numbers are
/// reported when the rows are read.
bool has_large_angles(const Recording& recording, const Convention& convention) try {
  std::vector<std::size_t> columns;
  for (const std::string& ours : names_of(Kind::euler))
    columns.push_back(find_column(recording.header(), ours, convention.columns.at(ours)));
  const RowSample& sample = recording.first_rows(columns);
  return std::ranges::any_of(columns, [&](std::size_t column) {
    const auto at = std::ranges::find(sample.columns, column) - sample.columns.begin();
    return std::ranges::any_of(sample.rows, [&](const std::vector<table::Number>& row) {
      return std::abs(row[static_cast<std::size_t>(at)].value) > 2 * std::numbers::pi;
    });
  });
} catch (const table::BadTable&) {
  return false;
}

}  // namespace

std::vector<Convention> with_angle_units(const Recording& recording, std::vector<Convention> open) {
  std::vector<Convention> all;
  for (Convention& convention : open) {
    const bool is_open = attitude_form(convention) == AttitudeForm::euler &&
                         !convention.angle_unit && angle_unit(convention) == Angle::radians;
    const bool may_be_degrees = is_open && has_large_angles(recording, convention);
    if (may_be_degrees) {
      all.push_back(convention);
      all.back().angle_unit = Angle::degrees;
    }
    all.push_back(std::move(convention));
  }
  return all;
}

}  // namespace twrench::recording
