#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "recording/row_reader.h"

namespace twrench::check {

/// A positive quantity that is roughly constant as long as its unit is.
class Level {
 public:
  /// `leap` is the least factor between units, `spread` the largest between rows of the same unit.
  Level(double leap, double spread) : leap_(leap), spread_(spread) {}

  /// Adds the value at the row that `reader` read last.
  void add(double value, const recording::RowReader& reader);

  /// The factor by which the quantity changes at place(); nothing if it does not change, or not for
  /// long.
  std::optional<double> factor() const;
  const std::string& place() const { return place_; }

 private:
  double leap_, spread_;
  std::optional<double> before_, after_;
  std::string place_;
  int rows_before_ = 0, rows_after_ = 0;
  bool stays_ = true;
};

/// Reads rows, and watches whether |L|, which a free body conserves, or the time between rows
/// changes by the ratio of two units and stays changed.
class UnitWatch {
 public:
  UnitWatch(recording::RowReader& reader, const Eigen::Matrix3d& inertia)
      : reader_(&reader), inertia_(inertia) {}

  /// Reads the next row, as RowReader::next() does.
  bool next(recording::Row& row);

  /// Throws table::BadTable if a unit changes; the error names the row where that begins.
  void require_one_unit() const;

 private:
  recording::RowReader* reader_;
  Eigen::Matrix3d inertia_;
  // A radian is 57 degrees, a revolution 6.3 radians, and a minute 60 s. Errors change |L| slowly.
  Level momentum_{4, 1.5}, interval_{30, 3};
  std::optional<double> last_time_;
};

}  // namespace twrench::check
