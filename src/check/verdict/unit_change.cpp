#include "check/verdict/unit_change.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "recording/conventions/units.h"
#include "table/error.h"

namespace twrench::check {
namespace {

/// Whether the factor is about the ratio of two units.
template <typename Name>
bool is_between_units(double factor, std::span<const Name> units, double Name::*size) {
  constexpr double about = 0.05;
  for (const Name& a : units) {
    for (const Name& b : units) {
      const double ratio = a.*size / b.*size;
      if (ratio != 1 && std::abs(factor / ratio - 1) < about) return true;
    }
  }
  return false;
}

table::BadTable unit_change(const Level& level, const char* what, const char* remedy) {
  return {level.place(),
          fmt::format("from this row on, {} is {:.4g} times as large as before: its unit changes",
                      what, *level.factor()),
          remedy};
}

}  // namespace

void Level::add(double value, const recording::RowReader& reader) {
  if (!(value > 0)) return;
  if (!before_) before_ = value;
  const bool leaps = value > leap_ * *before_ || value < *before_ / leap_;
  if (after_) {
    ++rows_after_;
    stays_ = stays_ && value < spread_ * *after_ && value > *after_ / spread_;
  } else if (leaps && !place_.empty()) {
    after_ = value;
  } else if (leaps) {
    // The interval between the last time in one unit and the first in another belongs to neither.
    place_ = reader.place();
  } else {
    place_.clear();
    before_ = value;
    ++rows_before_;
  }
}

std::optional<double> Level::factor() const {
  constexpr int few_rows = 3;
  if (!after_ || !stays_ || rows_before_ < few_rows || rows_after_ < few_rows) return std::nullopt;
  return *after_ / *before_;
}

bool UnitWatch::next(recording::Row& row) {
  if (!reader_->next(row)) return false;
  if (reader_->has_rates()) momentum_.add((inertia_ * row.omega).norm(), *reader_);
  if (last_time_) interval_.add(row.t - *last_time_, *reader_);
  last_time_ = row.t;
  return true;
}

void UnitWatch::require_one_unit() const {
  const auto of_momentum = momentum_.factor(), of_interval = interval_.factor();
  if (of_momentum && is_between_units(*of_momentum, recording::units_of_rates(),
                                      &recording::RateUnitName::in_rad_s)) {
    throw unit_change(momentum_, "the angular momentum",
                      "convert the rates to one unit, or give each unit a file");
  }
  if (of_interval && is_between_units(*of_interval, recording::common_units_of_times(),
                                      &recording::TimeUnitName::in_s)) {
    throw unit_change(interval_, "the time between rows",
                      "convert the times to one unit, or give each unit a file");
  }
}

}  // namespace twrench::check
