#pragma once

#include <span>
#include <vector>

#include "recording/rows.h"

namespace twrench::check {

/// Rows with the rates that their attitudes imply.
struct RowsWithRates {
  std::vector<recording::Row> rows;
  double noise = 0;  ///< standard deviation of their rates, relative to the largest |w|
};

/// Derives the rates from the attitudes of seven rows each, to order 6. The errors of the attitudes
/// have the standard deviation `error` in rad, from row to row: the larger it is, the farther apart
/// are the seven rows, unless the rates change much between them. Returns no rows if there are too
/// few, or if the body turns too far between them.
RowsWithRates with_rates_of_attitude(std::span<const recording::Row> rows, double error);

}  // namespace twrench::check
