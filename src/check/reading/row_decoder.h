#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "check/conventions/attitude.h"
#include "check/conventions/convention.h"
#include "check/conventions/names.h"
#include "check/reading/row.h"
#include "table/error.h"
#include "table/reader.h"

namespace twrench::check {

/// Takes the numbers of a file to the program's units and conventions.
class RowDecoder {
 public:
  /// `convention` names all columns, as conventions() returns it; `place` tells messages where the
  /// row stands. Throws as conventions() does, and InvalidArgument where rates in space axes come
  /// without an attitude.
  RowDecoder(const table::Header& header, const Convention& convention,
             std::function<std::string()> place);

  /// Of the file, in the order in which decode() takes their numbers.
  const std::vector<std::size_t>& columns() const { return columns_; }
  bool has_rates() const { return has_rates_; }
  AttitudeForm attitude() const { return form_; }
  std::span<const table::Number> rates_in(std::span<const table::Number> numbers) const;
  std::span<const table::Number> attitude_in(std::span<const table::Number> numbers) const;
  /// How many s one unit of the file's times has, and rad/s one of its rates.
  double second() const { return second_; }
  double rate_unit() const { return rate_unit_; }
  /// How many rad one unit of the numbers of the attitude has: 1 where they are no angles.
  double attitude_unit() const { return form_ == AttitudeForm::euler ? angle_unit_ : 1.0; }

  /// Sets all of the row but its number. Throws table::BadTable for numbers that are not finite or
  /// no rotation.
  void decode(std::span<const table::Number> numbers, Row& row) const;

 private:
  void select(const table::Header& header, const Convention& convention, Kind kind);
  void require_finite(std::span<const table::Number> numbers) const;
  void decode_attitude(std::span<const table::Number> numbers, Row& row) const;
  void decode_matrix(std::span<const table::Number> entries, Row& row) const;
  void decode_quaternion(std::span<const table::Number> numbers, Row& row) const;
  void decode_euler(std::span<const table::Number> numbers, Row& row) const;
  table::BadTable bad_attitude(const std::string& why, const std::string& remedy) const;

  AttitudeForm form_;
  bool has_rates_, rates_in_space_, inverse_, changes_axes_;
  double second_, rate_unit_, angle_unit_;
  Axes sequence_{2, 1, 0};
  Eigen::Matrix3d body_from_file_;  ///< of components of rates
  Eigen::Matrix3d turned_by_;       ///< what the attitude is multiplied by from the right
  std::vector<std::size_t> columns_;
  std::vector<std::string> names_;  ///< of the columns
  std::function<std::string()> place_;
};

}  // namespace twrench::check
