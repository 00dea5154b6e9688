#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::table {

/// Whether the cells of a column are calendar times, and of what kind.
enum class Calendar { none, date, time_of_day, date_time };

/// The names and units of a file's columns, and what it states about an attitude.
struct Header {
  std::string file;                ///< the path, as messages name it
  std::vector<std::string> names;  ///< in the file's order; "#1", "#2" ... if it has no names
  std::vector<std::string> units;  ///< of each column, from a row below the names; or empty
  std::optional<bool> states_inverse = {};  ///< whether the attitude is body from space
  std::string sequence = {};                ///< of Euler angles, "zyx"; empty if not stated
  /// The kind of each column, from the first row; empty if none has calendar times. Their numbers
  /// are in s since 1970, or since midnight.
  std::vector<Calendar> calendar = {};
  /// The lines before the names, then the comments before the rows without their marks.
  std::vector<std::string> preamble = {};
  /// For a column that was added, those from which it follows; empty for those of the file.
  std::vector<std::vector<std::size_t>> sources = {};

  Calendar calendar_of(std::size_t column) const {
    return column < calendar.size() ? calendar[column] : Calendar::none;
  }
  std::vector<std::size_t> sources_of(std::size_t column) const {
    return column < sources.size() ? sources[column] : std::vector<std::size_t>();
  }
};

/// A number, and how many digits of it were written.
struct Number {
  /// For numbers in binary formats: more digits than any double has.
  static constexpr int all_digits = 1100;

  double value = 0;  ///< the nearest double; infinite or NaN as in the file
  double rest = 0;   ///< the number as written minus `value`, for integers of at most 19 digits and
                     ///< numbers of at most 19 digits and 22 decimals; 0 for all others
  int decimals = all_digits;     ///< decimal places of the number without an exponent; negative if
                                 ///< its last digit is before the units: -2 for 12e2
  int significant = all_digits;  ///< digits from the first nonzero one; 0 for zero
};

/// A column of numbers in memory.
struct Column {
  std::string name;
  const double* first;  ///< the number of the first row
  std::ptrdiff_t step;  ///< from the number of one row to that of the next, in doubles
};

/// The rows of a table, in memory that does not grow with the file. It is opened once and may be
/// read several times.
class Reader {
 public:
  virtual ~Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const Header& header() const { return header_; }

  /// Begins a pass over the rows: goes to the first one, and selects the columns that next()
  /// returns, by their indices in the header and in this order; a column may occur twice. Other
  /// columns are not converted. Throws BadTable if a column cannot have numbers.
  virtual void begin_pass(std::span<const std::size_t> columns) = 0;

  /// Reads the next row: as many numbers as columns were selected. Returns false at the end. Throws
  /// BadTable for a cell that is not a number in the range of doubles, and system::FileError if the
  /// file cannot be read, is not a table from here on, or has changed since it was opened.
  virtual bool next(std::span<Number> numbers) = 0;

  /// Location of the row read last: "run.csv:17", or "run.npy: row 16" in a file without lines.
  virtual std::string place() const = 0;

 protected:
  Reader() = default;

  Header header_;
};

/// Opens a CSV, TSV, JSON or NumPy file, recognised by its first bytes rather than its name. Throws
/// system::FileError if it cannot be read or is not a table, and BadTable if it has no rows.
std::unique_ptr<Reader> open_table(const std::filesystem::path& path);

/// Does the same for the bytes of a file, which must outlive the reader; messages call it `name`.
std::unique_ptr<Reader> open_table(const std::string& name, std::string_view bytes);

/// Does the same for columns in memory with `rows` numbers each, which must outlive the reader.
std::unique_ptr<Reader> open_table(const std::string& name, std::vector<Column> columns,
                                   std::size_t rows);

}  // namespace twrench::table
