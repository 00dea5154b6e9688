#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "table/error.h"
#include "table/reader.h"

namespace twrench::recording {

/// The rows of a table without those at its start and at its end that lack a number, as of a body
/// that cameras do not see yet: a cell that is empty or not a number. Such a row between others is
/// an error.
class FilledRows : public table::Reader {
 public:
  explicit FilledRows(std::unique_ptr<table::Reader> table);

  void begin_pass(std::span<const std::size_t> columns) override;
  bool next(std::span<table::Number> numbers) override;
  std::string place() const override { return table_->place(); }

  /// The rows that the last complete pass left out: "run.csv:2 to run.csv:5"; empty if none.
  std::string left_out() const;

 private:
  /// Rows one after another.
  struct Rows {
    std::string first, last;  ///< their places
  };

  std::optional<table::BadTable> error_of_next(std::span<table::Number> numbers);

  std::unique_ptr<table::Reader> table_;
  std::vector<std::size_t> columns_;
  bool has_begun_ = false, has_ended_ = false;
  Rows at_start_, at_end_;
  std::optional<table::BadTable> error_;  ///< of the first row that lacks a number after others
};

}  // namespace twrench::recording
