#include "check/verdict/unit_change.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "check/conventions/units.h"
#include "check/reading/row_reader.h"
#include "check/verdict/stop.h"
#include "table/error.h"

namespace twrench::check {
namespace {

/// A positive quantity that is roughly constant as long as its unit is.
class Level {
 public:
  /// `leap` is the least factor between units, `spread` the largest between rows of the same unit.
  Level(double leap, double spread) : leap_(leap), spread_(spread) {}

  void add(double value, const std::string& place) {
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
      place_ = place;
    } else {
      place_.clear();
      before_ = value;
      ++rows_before_;
    }
  }

  /// The factor by which the quantity changes at place(); nothing if it does not change, or not for
  /// long.
  std::optional<double> factor() const {
    constexpr int few_rows = 3;
    if (!after_ || !stays_ || rows_before_ < few_rows || rows_after_ < few_rows)
      return std::nullopt;
    return *after_ / *before_;
  }
  const std::string& place() const { return place_; }

 private:
  double leap_, spread_;
  std::optional<double> before_, after_;
  std::string place_;
  int rows_before_ = 0, rows_after_ = 0;
  bool stays_ = true;
};

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

void require_one_unit(const std::filesystem::path& file, const Convention& convention,
                      const Eigen::Matrix3d& inertia, const std::atomic<bool>* stop) {
  // A radian is 57 degrees, a revolution 6.3 radians, and a minute 60 s. Errors change |L| slowly.
  Level momentum(4, 1.5), interval(30, 3);
  RowReader reader(file, convention);
  Row row;
  std::optional<double> last;
  while (reader.next(row)) {
    throw_if_stopped(stop);
    const std::string place = reader.place();
    if (reader.has_rates()) momentum.add((inertia * row.omega).norm(), place);
    if (last) interval.add(row.t - *last, place);
    last = row.t;
  }
  const auto of_momentum = momentum.factor(), of_interval = interval.factor();
  if (of_momentum && is_between_units(*of_momentum, rate_units(), &RateUnitName::in_rad_s)) {
    throw unit_change(momentum, "the angular momentum",
                      "convert the rates to one unit, or give each unit a file");
  }
  if (of_interval && is_between_units(*of_interval, time_units(), &TimeUnitName::in_s)) {
    throw unit_change(interval, "the time between rows",
                      "convert the times to one unit, or give each unit a file");
  }
}

}  // namespace twrench::check
