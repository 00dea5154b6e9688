#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "check/conventions/convention.h"
#include "check/reading/resolution.h"
#include "check/reading/row.h"
#include "table/reader.h"

namespace twrench::check {

/// One pass over a recorded trajectory, in memory that does not grow with the file.
class RowReader {
 public:
  /// Opens the file; `convention` names all columns, as conventions() returns it. Throws what
  /// table::open_table and conventions() throw, and InvalidArgument where rates in space axes come
  /// without an attitude.
  RowReader(const std::filesystem::path& file, const Convention& convention);
  /// The same for a table that is open.
  RowReader(std::unique_ptr<table::Reader> table, const Convention& convention);
  ~RowReader();
  RowReader(RowReader&&) noexcept;
  RowReader& operator=(RowReader&&) noexcept;

  bool has_rates() const;
  AttitudeForm attitude() const;

  /// Reads the next row. Returns false at the end. Throws system::FileError where the file cannot
  /// be read, and table::BadTable, about the row and the column, for what is no number, not finite,
  /// out of the order of time, no rotation.
  bool next(Row& row);

  /// Where the row read last stands: "run.csv:17", or "run.npy: row 16" in a file without lines.
  std::string place() const;

  // Of the rows read so far: known after the pass.

  /// s. Of equally spaced times that are exact in all their digits, that of doubles.
  Resolution time_resolution() const;
  /// rad/s.
  Resolution rate_resolution() const;
  /// Of the numbers of the attitude: entries of the matrix or of the quaternion; rad for Euler
  /// angles.
  Resolution attitude_resolution() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace twrench::check
