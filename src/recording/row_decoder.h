#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "recording/conventions/attitude.h"
#include "recording/conventions/convention.h"
#include "recording/conventions/names.h"
#include "recording/rows.h"
#include "table/error.h"
#include "table/reader.h"

namespace twrench::recording {

/// Converts the numbers of a file to the program's units and conventions.
class RowDecoder {
 public:
  /// `convention` names all columns, as those of conventions() do; `place` returns the location of
  /// the row for messages. Throws as conventions() does, and InvalidArgument if rates in space axes
  /// come without an attitude.
  RowDecoder(const table::Header& header, const Convention& convention,
             std::function<std::string()> place);

  /// The indices of the file's columns, in the order in which decode() expects their numbers.
  const std::vector<std::size_t>& columns() const { return columns_; }
  bool has_rates() const { return has_rates_; }
  /// Whether the rates follow from angular momenta.
  bool has_momentum() const { return has_momentum_; }
  AttitudeForm attitude() const { return form_; }
  std::span<const table::Number> rates_in(std::span<const table::Number> numbers) const;
  std::span<const table::Number> attitude_in(std::span<const table::Number> numbers) const;
  /// The file's unit of times in s, and its unit of rates in rad/s.
  double second() const { return second_; }
  double rate_unit() const { return rate_unit_; }
  /// The largest component of the rates, rad/s, for an angular momentum whose components, in the
  /// file's unit, are at most 1.
  double rates_of_unit_momentum() const {
    return rate_unit_ * rates_from_momentum_.cwiseAbs().rowwise().sum().maxCoeff();
  }
  /// The unit of the attitude's numbers in rad; 1 if they are not all angles.
  double attitude_unit() const;

  /// Sets the row whose time is 0: that of the first row. Digits that a clock counting from 1970
  /// needs for its years are then not lost, because the numbers are subtracted before they are
  /// converted. The row also determines the length of quaternions.
  void set_first_row(std::span<const table::Number> numbers);
  /// The time from one row to another in s.
  double seconds_between(const table::Number& from, const table::Number& to) const {
    return second_ * ((to.value - from.value) + (to.rest - from.rest));
  }
  /// The time of the first row in s, on the file's clock.
  double first_time() const { return second_ * first_time_.value; }
  /// The length that all quaternions have up to rounding: 1, unless that of the first row is far
  /// from it, as in a file of integers.
  double quaternion_length() const { return quaternion_length_; }

  /// Sets everything in the row except its number. Throws table::BadTable if the numbers are not
  /// finite, beyond the limits of times and rates, or not a rotation.
  void decode(std::span<const table::Number> numbers, Row& row) const;

 private:
  void select(const table::Header& header, const Convention& convention, Kind kind);
  void require_finite(std::span<const table::Number> numbers) const;
  void require_within_limits(std::span<const table::Number> numbers, const Row& row) const;
  void require_speed(const Row& row) const;
  void decode_attitude(std::span<const table::Number> numbers, Row& row) const;
  void decode_matrix(std::span<const table::Number> entries, Row& row) const;
  table::BadTable bad_quaternion(double length) const;
  void decode_quaternion(std::span<const table::Number> numbers, Row& row) const;
  void decode_euler(std::span<const table::Number> numbers, Row& row) const;
  void decode_axis_angle(std::span<const table::Number> numbers, Row& row) const;
  void decode_rodrigues(std::span<const table::Number> numbers, Row& row) const;
  table::BadTable bad_attitude(const std::string& why, const std::string& remedy) const;

  AttitudeForm form_;
  bool has_rates_, has_momentum_, from_space_axes_, inverse_, changes_axes_;
  std::optional<std::size_t> negated_;  ///< index of Convention::negated in (w, x, y, z)
  double second_, rate_unit_, unit_of_angles_;
  double quaternion_length_ = 1;
  Axes sequence_{2, 1, 0};
  Eigen::Matrix3d rates_from_momentum_;  ///< the inverse of the inertia
  Eigen::Matrix3d body_from_file_;       ///< applies to the rates
  Eigen::Matrix3d turned_by_;            ///< multiplies the attitude from the right
  table::Number first_time_;
  std::vector<std::size_t> columns_;
  std::vector<std::string> names_;  ///< of the columns
  std::function<std::string()> place_;
};

}  // namespace twrench::recording
