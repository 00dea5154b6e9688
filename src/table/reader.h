#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::table {

/// What a file says of its columns.
struct Header {
  std::string file;                ///< the path, as messages name it
  std::vector<std::string> names;  ///< in the file's order; "#1", "#2" ... where it has no names
  std::vector<std::string> units;  ///< of each column, from a row below the names; or empty
};

/// A number, and how many digits of it were written.
struct Number {
  /// Of numbers of a binary format: more than any double has.
  static constexpr int all_digits = 1100;

  double value = 0;              ///< as near as a double can be; may be infinite or NaN where the
                                 ///< file says so
  int decimals = all_digits;     ///< places after the point of the number written in full; negative
                                 ///< where it ends before the units: -2 for 12e2
  int significant = all_digits;  ///< digits from the first that is not 0; 0 of a zero
};

/// One pass over the rows of a table, in memory that does not grow with the file.
class Reader {
 public:
  virtual ~Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const Header& header() const { return header_; }

  /// Says which columns next() returns, by their indices in the header, in this order; a column may
  /// be named twice. To be called once, before next(). The others are not converted.
  virtual void select(std::span<const std::size_t> columns) = 0;

  /// Reads the next row: as many numbers as columns were selected. Returns false at the end. Throws
  /// BadTable for a cell that is no number a double can hold, and system::FileError where the file
  /// cannot be read or is no table from here on.
  virtual bool next(std::span<Number> numbers) = 0;

  /// Where the row read last stands: "run.csv:17", or "run.npy: row 16" in a file without lines.
  virtual std::string place() const = 0;

 protected:
  Reader() = default;

  Header header_;
};

/// Opens a CSV, TSV, JSON or NumPy file, recognised by its first bytes, not by its name.
/// Throws system::FileError where it cannot be read or is no table, BadTable where it has no rows.
std::unique_ptr<Reader> open_table(const std::filesystem::path& path);

/// The same for the bytes of a file, which must outlive the reader; messages call it `name`.
std::unique_ptr<Reader> open_table(const std::string& name, std::string_view bytes);

}  // namespace twrench::table
