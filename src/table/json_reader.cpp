#include "table/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "system/error.h"
#include "table/calendar.h"
#include "table/error.h"
#include "table/json_columns.h"

namespace twrench::table {

JsonReader::JsonReader(Input input, bool is_converted)
    : input_(std::move(input)), is_converted_(is_converted), cursor_(input_) {
  header_.file = input_.name();
  open_rows();
  if (!next_row()) throw BadTable(header_.file, "it has no rows");
  header_.names = row_.names;
  find_calendar_times();
}

void JsonReader::find_calendar_times() {
  std::vector<Calendar> calendar;
  for (const JsonCell& cell : row_.cells) {
    Number number;
    const bool is_text = cell.kind == JsonCell::Kind::other;
    calendar.push_back(is_text ? read_calendar(cell.text, number) : Calendar::none);
  }
  const bool has_any =
      std::ranges::any_of(calendar, [](Calendar kind) { return kind != Calendar::none; });
  if (has_any) header_.calendar = std::move(calendar);
}

/// Moves to the first row. A file without an array of rows may be a single object, which is
/// converted.
void JsonReader::open_rows() {
  std::optional<system::FileError> error;
  try {
    find_rows();
  } catch (const system::FileError& too_long) {
    error = too_long;
  }
  if (!error && layout_ != Layout::lines) return;
  auto rows = rows_of_object(input_);
  if (!rows && error) throw system::FileError(*error);
  if (!rows) return;
  input_ = std::move(rows->rows);
  header_.preamble = std::move(rows->preamble);
  is_converted_ = true;
  find_rows();
}

std::string JsonReader::place() const {
  return is_converted_ ? fmt::format("{}: row {}", header_.file, cursor_.line()) : cursor_.place();
}

/// Moves to the first row.
void JsonReader::find_rows() {
  cursor_ = JsonCursor(input_);
  at_first_ = true;
  if (cursor_.take_if('[')) {
    layout_ = Layout::array;
  } else if (find_samples()) {
    layout_ = Layout::samples;
  } else {
    layout_ = Layout::lines;
    cursor_ = JsonCursor(input_);
  }
}

/// Moves past "samples": [ of the object that begins here. Returns false if the object has none.
bool JsonReader::find_samples() {
  cursor_.expect('{');
  if (cursor_.take_if('}')) return false;
  do {
    const bool is_samples = cursor_.take_value() == "\"samples\"";
    cursor_.expect(':');
    if (is_samples && cursor_.take_if('[')) return true;
    cursor_.take_value();
  } while (cursor_.take_if(','));
  return false;
}

bool JsonReader::next_row() {
  if (layout_ == Layout::lines) {
    if (!cursor_.peek()) return false;
  } else if (cursor_.take_if(']')) {
    finish();
    return false;
  } else if (!at_first_) {
    cursor_.expect(',');
  }
  at_first_ = false;
  const std::string_view text = cursor_.take_value();
  read_json_row(text, place(), row_);
  return true;
}

/// Reads the text after the rows, to detect a truncated file.
void JsonReader::finish() {
  while (layout_ == Layout::samples && cursor_.take_if(',')) {
    cursor_.take_value();
    cursor_.expect(':');
    cursor_.take_value();
  }
  if (layout_ == Layout::samples) cursor_.expect('}');
  if (!cursor_.peek()) return;
  throw system::FileError(cursor_.place_here(),
                          "there is more text after the end of the JSON value");
}

void JsonReader::begin_pass(std::span<const std::size_t> columns) {
  find_rows();
  selected_.assign(columns.begin(), columns.end());
}

/// The cell of this row for a column of the first row, whatever its position.
const JsonCell& JsonReader::cell_of(std::size_t column) const {
  static const JsonCell missing;
  const std::string& name = header_.names[column];
  if (column < row_.names.size() && row_.names[column] == name) return row_.cells[column];
  const auto found = std::ranges::find(row_.names, name);
  if (found == row_.names.end()) return missing;
  return row_.cells[static_cast<std::size_t>(found - row_.names.begin())];
}

bool JsonReader::next(std::span<Number> numbers) {
  if (!next_row()) return false;
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const std::string& name = header_.names[selected_[i]];
    const JsonCell& cell = cell_of(selected_[i]);
    if (const Calendar kind = header_.calendar_of(selected_[i]); kind != Calendar::none) {
      if (read_calendar(cell.text, numbers[i]) == kind) continue;
      throw no_calendar_time(place(), name, cell.text);
    }
    switch (cell.kind) {
      case JsonCell::Kind::missing:
        throw system::FileError(place(), fmt::format("the row has no '{}'", name),
                                "each row needs what the first one has");
      case JsonCell::Kind::too_large:
        throw too_large(place(), name, cell.text);
      case JsonCell::Kind::other:
        throw no_number(place(), name, cell.text);
      case JsonCell::Kind::number:
        numbers[i] = cell.number;
    }
  }
  return true;
}

}  // namespace twrench::table
