#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "archive/zip_archive.h"
#include "table/npy_header.h"
#include "table/npy_reader.h"
#include "table/reader.h"

namespace twrench::table {

/// The rows of the arrays in an archive of numpy.savez or numpy.savez_compressed: of all that have
/// as many rows as the longest ones. Memory does not grow with them.
class NpzReader : public Reader {
 public:
  explicit NpzReader(Input input);

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<Number> numbers) override;
  std::string place() const override;

 private:
  struct Array {
    archive::ZipMember member;
    NpyHeader layout;
  };

  /// The place of a column of the table.
  struct Source {
    std::size_t array, column;
  };

  /// Numbers of an array that lie one after another: its rows, or one of its columns.
  struct Rows {
    std::size_t array;
    std::size_t row_bytes;
    archive::ZipArchive::Stream stream;
    std::vector<char> buffer = {};
    std::size_t begin = 0, end = 0;  ///< the unread part of the buffer
  };

  struct Selected {
    std::size_t rows;    ///< index in rows_
    std::size_t offset;  ///< in a row, bytes
    NpyDecode decode;
  };

  void read_arrays();
  void require_no_cut_array() const;
  void name_columns();
  std::size_t open_rows(std::size_t array, std::uint64_t begin, std::size_t row_bytes);
  void advance(Rows& rows) const;

  Input input_;
  archive::ZipArchive archive_;
  std::vector<Array> arrays_;
  std::vector<Source> sources_;  ///< of each column in the header
  std::uint64_t row_count_ = 0, row_ = 0;
  std::vector<Rows> rows_;
  std::vector<Selected> selected_;
};

}  // namespace twrench::table
