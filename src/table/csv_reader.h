#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "table/calendar.h"
#include "table/dialect.h"
#include "table/input.h"
#include "table/line_reader.h"
#include "table/reader.h"

namespace twrench::table {

/// Reads rows that are lines of text, with cells separated by commas, semicolons, tabs, bars or
/// blanks.
class CsvReader : public Reader {
 public:
  /// `sequence` is that of Euler angles, if the file states it.
  explicit CsvReader(Input input, std::string sequence = {});

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<Number> numbers) override;
  std::string place() const override;

 private:
  struct Selected {
    std::size_t column, place;  ///< index in the file, and among the numbers of next()
    bool has_calendar_times;
    DateOrder order;
    std::string date;  ///< of the first row, if the order of its day and month is open
  };

  void read_header(const Sample& sample);
  void find_calendar_times(std::span<const Sample::Line> rows);
  bool next_line(std::string_view& line);
  void read_blanks_or_quotes(std::string_view line, std::span<Number> numbers);
  void read_cell(std::string_view cell, Selected& selected, std::span<Number> numbers) const;
  void read_calendar_time(std::string_view cell, Selected& selected,
                          std::span<Number> numbers) const;
  void require_columns(std::size_t count, std::string_view last) const;

  Input input_;
  Dialect dialect_;
  bool semicolon_marks_comment_ = true;
  LineReader lines_;
  std::size_t first_line_ = 1;      ///< the first that may be a row
  std::vector<DateOrder> orders_;   ///< of the dates in each column
  std::vector<Selected> selected_;  ///< in the order of the file's columns
  std::vector<std::string_view> cells_;
};

}  // namespace twrench::table
