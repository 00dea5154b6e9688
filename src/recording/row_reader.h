#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "recording/conventions/convention.h"
#include "recording/digits.h"
#include "recording/rows.h"
#include "table/reader.h"

namespace twrench::recording {

/// One pass over the rows of a table, in memory that does not grow with it.
class RowReader {
 public:
  /// Begins the pass, which ends any other over the same table. `convention` names all columns, as
  /// those of conventions() do. Rows outside of the extract are skipped: the first one within it is
  /// row 1 at t = 0. Throws what conventions() throws, and InvalidArgument if rates in space axes
  /// come without an attitude.
  RowReader(std::shared_ptr<table::Reader> table, const Convention& convention,
            const Extract& extract = {});
  ~RowReader();
  RowReader(RowReader&&) noexcept;
  RowReader& operator=(RowReader&&) noexcept;

  bool has_rates() const;
  AttitudeForm attitude() const;

  /// The time of the first row in s, on the file's clock; known after it was read.
  double first_time() const;

  /// The length of the quaternions, known after the first row was read; 1 for other attitudes.
  double quaternion_length() const;

  /// Reads the next row. Returns false at the end. Throws system::FileError if the file cannot be
  /// read, and table::BadTable, naming the row and the column, if a value is not a number, not
  /// finite, beyond the limits, out of the order of time, or not a rotation.
  bool next(Row& row);

  /// Location of the row read last: "run.csv:17", or "run.npy: row 16" in a file without lines.
  std::string place() const;

  // Resolutions of the rows read so far; final after the pass.

  /// s, for times since the first row. That of doubles if the times are exact in all their digits,
  /// because they are equally spaced or a few round numbers.
  Resolution time_resolution() const;
  /// rad/s. That of doubles if the rates are round numbers beside an attitude with all digits of
  /// doubles: a program that prints these does not round 20.
  Resolution rate_resolution() const;
  /// For the entries of the matrix or of the quaternion, or for the Euler angles in rad.
  Resolution attitude_resolution() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace twrench::recording
