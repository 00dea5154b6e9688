#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recording/columns/derived_times.h"
#include "recording/conventions/convention.h"
#include "recording/filled_rows.h"
#include "recording/row_reader.h"
#include "recording/rows.h"
#include "table/reader.h"

namespace twrench::recording {

/// Rows of a table as numbers, which a convention gives a meaning.
struct RowSample {
  table::Header header;
  std::vector<std::size_t> columns;
  std::vector<std::vector<table::Number>> rows;
  std::vector<std::string> places;  ///< of the rows in the table, for messages
};

/// A recorded motion: the rows of a table, which is opened once and may be read several times and
/// in several conventions. Only the first rows stay in memory. Copies share the table; no two
/// threads may read it at once.
class Recording {
 public:
  explicit Recording(std::unique_ptr<table::Reader> table)
      : table_(std::make_shared<FilledRows>(with_derived_times(std::move(table)))) {}
  /// Opens a file. Throws what table::open_table throws.
  explicit Recording(const std::filesystem::path& file) : Recording(table::open_table(file)) {
    path_ = file;
  }

  /// Returns the same recording with only these rows.
  Recording between(const Extract& extract) const {
    Recording part = *this;
    part.extract_ = extract;
    return part;
  }

  /// Returns the same recording with a table of its own, which another thread may read. Only for a
  /// file. Throws what table::open_table throws.
  Recording reopened() const { return Recording(path_).between(extract_); }

  const table::Header& header() const { return table_->header(); }
  /// The path of the file, or the name that messages give to a table in memory.
  const std::string& name() const { return header().file; }

  /// The rows at the start and the end that the last pass left out because they lack a number.
  std::string left_out() const { return table_->left_out(); }

  /// The path of the file; empty for a table in memory.
  const std::filesystem::path& path() const { return path_; }

  /// Begins a pass over the rows, which ends the one before. Throws as RowReader does.
  RowReader rows(const Convention& convention) const { return {table_, convention, extract_}; }

  /// The first rows of the table, up to 4096, with at least these columns. They are read again only
  /// for other columns, which ends a pass over the rows. Throws as table::Reader does.
  const RowSample& first_rows(const std::vector<std::size_t>& columns) const;

  /// The same of the extract. The first of the columns has the times, in units of `second` s.
  const RowSample& first_rows_of_extract(const std::vector<std::size_t>& columns,
                                         double second) const;

 private:
  std::shared_ptr<FilledRows> table_;
  std::filesystem::path path_;
  Extract extract_;
  mutable RowSample first_rows_, first_rows_of_extract_;
  mutable double second_ = 0;  ///< of first_rows_of_extract_
};

}  // namespace twrench::recording
