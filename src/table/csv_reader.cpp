#include "table/csv_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "system/error.h"
#include "table/csv_header.h"
#include "table/error.h"
#include "table/number_text.h"
#include "table/preamble.h"

namespace twrench::table {
namespace {

DateOrder order_or_day_first(DateOrder order) {
  return order == DateOrder::open ? DateOrder::day_first : order;
}

/// MATLAB writes a duration as "0.02 sec".
std::string_view without_seconds(std::string_view cell) {
  if (cell.ends_with(" sec")) cell.remove_suffix(4);
  return cell;
}

}  // namespace

CsvReader::CsvReader(Input input, std::string sequence) : input_(std::move(input)), lines_(input_) {
  header_.file = input_.name();
  header_.sequence = std::move(sequence);
  header_.preamble = find_preamble(input_);
  const Sample sample = read_sample(input_, header_.preamble.size());
  if (sample.lines.empty())
    throw BadTable(header_.file, "it has no rows, only blank lines and comments");
  if (sample.lines.front().text.find('\r') != std::string::npos) {
    throw system::FileError(header_.file, "its lines end with CR alone",
                            "let them end with LF: tr '\\r' '\\n'");
  }
  semicolon_marks_comment_ = sample.semicolon_marks_comment;
  dialect_ = detect_dialect(sample, header_.file);
  read_header(sample);
  std::ranges::copy(sample.comments, std::back_inserter(header_.preamble));
}

void CsvReader::read_header(const Sample& sample) {
  CsvHeader header = find_csv_header(sample, dialect_.separator);
  header_.names = std::move(header.names);
  add_groups(header_.preamble, dialect_.separator, header_.names);
  header_.units = std::move(header.units);
  if (header.first_row == sample.lines.size()) {
    throw BadTable(header_.file, "it has a header, but no rows");
  }
  first_line_ = sample.lines[header.first_row].number;
  find_calendar_times(std::span(sample.lines).subspan(header.first_row));
}

/// The first row has the kinds of the columns, and any row the order of the day and the month. If
/// none has it, the differences of times are right in either order as long as the date stays.
void CsvReader::find_calendar_times(std::span<const Sample::Line> rows) {
  std::vector<Calendar> calendar(header_.names.size());
  orders_.assign(header_.names.size(), DateOrder::open);
  for (const Sample::Line& row : rows) {
    split_cells(row.text, dialect_.separator, cells_);
    for (std::size_t i = 0; i < std::min(cells_.size(), calendar.size()); ++i) {
      if (is_numeric(cells_[i])) continue;
      if (orders_[i] == DateOrder::open) orders_[i] = stated_order(cells_[i]);
      Number number;
      if (&row == &rows.front())
        calendar[i] = read_calendar(cells_[i], number, order_or_day_first(orders_[i]));
    }
  }
  const bool has_any =
      std::ranges::any_of(calendar, [](Calendar kind) { return kind != Calendar::none; });
  if (has_any) header_.calendar = std::move(calendar);
}

void CsvReader::begin_pass(std::span<const std::size_t> columns) {
  lines_ = LineReader(input_);
  selected_.clear();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool has_calendar_times = header_.calendar_of(columns[i]) != Calendar::none;
    selected_.push_back({columns[i], i, has_calendar_times, orders_[columns[i]], {}});
  }
  std::ranges::sort(selected_, {}, &Selected::column);
}

std::string CsvReader::place() const { return lines_.place(); }

bool CsvReader::next_line(std::string_view& line) {
  do {
    if (!lines_.next(line)) return false;
  } while (lines_.number() < first_line_ || is_blank_or_comment(line, semicolon_marks_comment_));
  return true;
}

bool CsvReader::next(std::span<Number> numbers) {
  std::string_view line;
  if (!next_line(line)) return false;
  const char separator = dialect_.separator;
  if (separator == ' ' || line.find('"') != std::string_view::npos) {
    read_blanks_or_quotes(line, numbers);
    return true;
  }
  constexpr std::size_t at_end = std::string_view::npos;
  std::size_t column = 0, begin = 0, end = line.find(separator);
  for (Selected& selected : selected_) {
    for (; column < selected.column && end != at_end; ++column) {
      begin = end + 1;
      end = line.find(separator, begin);
    }
    if (column < selected.column) break;
    read_cell(line.substr(begin, end - begin), selected, numbers);
  }
  const std::string_view rest = end == at_end ? std::string_view{} : line.substr(end);
  const auto more = static_cast<std::size_t>(std::ranges::count(rest, separator));
  require_columns(column + 1 + more, line.substr(line.rfind(separator) + 1));
  return true;
}

void CsvReader::read_blanks_or_quotes(std::string_view line, std::span<Number> numbers) {
  if (!split_cells(line, dialect_.separator, cells_)) {
    throw system::FileError(place(), "a quotation mark is not closed on this line",
                            "each row must be on one line");
  }
  require_columns(cells_.size(), cells_.back());
  for (Selected& selected : selected_) {
    const bool is_there = selected.column < cells_.size();
    read_cell(is_there ? cells_[selected.column] : "", selected, numbers);
  }
}

void CsvReader::read_cell(std::string_view cell, Selected& selected,
                          std::span<Number> numbers) const {
  if (selected.has_calendar_times) {
    read_calendar_time(trimmed(cell), selected, numbers);
    return;
  }
  Number& number = numbers[selected.place];
  Reading reading = read_number(cell, dialect_.decimal_comma, number);
  if (reading == Reading::text) {
    cell = trimmed(cell);
    reading = read_number(without_seconds(cell), dialect_.decimal_comma, number);
  }
  const std::string& name = header_.names[selected.column];
  if (reading == Reading::text && cell.empty())
    throw EmptyCell(cell_place(place(), name), "the cell is empty",
                    "each row needs a number there");
  if (reading == Reading::text) throw no_number(place(), name, cell);
  if (reading == Reading::too_large) throw too_large(place(), name, cell);
}

void CsvReader::read_calendar_time(std::string_view cell, Selected& selected,
                                   std::span<Number> numbers) const {
  Number& number = numbers[selected.place];
  Calendar kind = read_calendar(cell, number, selected.order);
  if (kind == Calendar::none && selected.order == DateOrder::open) {
    kind = read_calendar(cell, number, DateOrder::day_first);
    const std::string_view date = cell.substr(0, cell.find_first_of(" T"));
    if (selected.date.empty()) selected.date = date;
    if (selected.date != date) {
      throw BadTable(cell_place(place(), header_.names[selected.column]),
                     fmt::format("the dates {} and {} may begin with the day or with the month",
                                 selected.date, date),
                     "write dates as 2026-03-04");
    }
  }
  if (kind == header_.calendar_of(selected.column)) return;
  throw no_calendar_time(place(), header_.names[selected.column], cell);
}

void CsvReader::require_columns(std::size_t count, std::string_view last) const {
  const std::size_t expected = header_.names.size();
  const bool row_ends_with_separator = count == expected + 1 && trimmed(last).empty();
  const bool names_end_with_separator = count + 1 == expected && header_.names.back().empty();
  if (count == expected || row_ends_with_separator || names_end_with_separator) return;
  throw system::FileError(
      place(),
      fmt::format("the row has {} cell{}, but there are {} columns", count, count == 1 ? "" : "s",
                  expected),
      "each row needs a cell for each column; between decimal commas, cells need semicolons");
}

}  // namespace twrench::table
