#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "table/input.h"
#include "table/json_cursor.h"
#include "table/json_row.h"
#include "table/reader.h"

namespace twrench::table {

/// Reads rows that are JSON objects or arrays: in an array, in the array "samples" of an object, or
/// one after another (JSON Lines). Objects that have their rows in another member, or columns as
/// arrays, are converted first.
class JsonReader : public Reader {
 public:
  /// `is_converted` is whether the input was converted from another format, so that its lines are
  /// not those of the file.
  explicit JsonReader(Input input, bool is_converted = false);

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<Number> numbers) override;
  std::string place() const override;

 private:
  enum class Layout { lines, array, samples };

  void open_rows();
  void find_rows();
  bool find_samples();
  void find_calendar_times();
  bool next_row();
  void finish();
  const JsonCell& cell_of(std::size_t column) const;

  Input input_;
  bool is_converted_;  ///< the lines are then rows, not those of the file
  JsonCursor cursor_;
  Layout layout_ = Layout::array;
  bool at_first_ = true;  ///< no row was taken yet
  JsonCells row_;
  std::vector<std::size_t> selected_;
};

}  // namespace twrench::table
