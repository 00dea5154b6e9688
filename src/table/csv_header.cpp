#include "table/csv_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "table/number_text.h"
#include "table/ros_message.h"

namespace twrench::table {
namespace {

using Cells = std::vector<std::string_view>;

Cells cells_of(std::string_view line, char separator) {
  Cells cells;
  split_cells(line, separator, cells);
  return cells;
}

/// The cells without the empty one after a separator at the end of the line.
std::span<const std::string_view> without_empty_end(const Cells& cells) {
  const bool ends_empty = !cells.empty() && cells.back().empty();
  return std::span(cells).first(cells.size() - (ends_empty ? 1 : 0));
}

std::string without_doubled_quotes(std::string_view cell) {
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    text += cell[i];
    if (cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"') ++i;
  }
  return text;
}

/// Whether the cell contains a unit of times, angles or rates and nothing else.
bool is_known_unit(std::string_view cell) {
  constexpr std::array known{"s",     "sec",   "ms",      "us",      "ns",     "deg",      "rad",
                             "deg/s", "rad/s", "deg/sec", "rad/sec", "\u00b0", "\u00b0/s", "mm"};
  const bool bracketed = cell.size() > 2 && (cell.front() == '[' || cell.front() == '(');
  if (bracketed) cell = cell.substr(1, cell.size() - 2);
  return std::ranges::find(known, cell) != known.end();
}

bool is_name(std::string_view cell) { return !cell.empty() && !is_numeric(cell); }

/// Whether the cell of this line is in quotation marks.
bool is_quoted(std::string_view cell, std::string_view line) {
  return cell.data() > line.data() && cell.data()[-1] == '"';
}

/// The cells of a column below the first line.
struct ColumnBelow {
  bool has_number = false, has_quotes = false;
};

std::vector<ColumnBelow> columns_below(const Sample& sample, char separator) {
  std::vector<ColumnBelow> columns(cells_of(sample.lines[0].text, separator).size());
  for (const Sample::Line& line : std::span(sample.lines).subspan(1)) {
    const Cells cells = cells_of(line.text, separator);
    for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) {
      if (!is_numeric(cells[i])) continue;
      columns[i].has_number = true;
      columns[i].has_quotes = columns[i].has_quotes || is_quoted(cells[i], line.text);
    }
  }
  return columns;
}

/// Whether the numbers are 0, 1, 2 ..., as programs count columns without names.
bool count_from_zero(std::span<const std::string_view> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != fmt::format("{}", i)) return false;
  }
  return true;
}

/// Whether the first line has names rather than values. Only columns with numbers below count,
/// because a column of words has a word in its header and in each row. A few names may be numbers.
bool is_header(const Sample& sample, char separator) {
  const std::string& line = sample.lines[0].text;
  const Cells cells = cells_of(line, separator);
  const std::vector<ColumnBelow> below = columns_below(sample, separator);
  const bool has_numbers = std::ranges::any_of(below, &ColumnBelow::has_number);
  Cells names, numbers;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty() || (has_numbers && !below[i].has_number)) continue;
    const bool is_quoted_name = has_numbers && is_quoted(cells[i], line) && !below[i].has_quotes;
    (is_name(cells[i]) || is_quoted_name ? names : numbers).push_back(cells[i]);
  }
  if (names.empty()) return false;
  if (numbers.size() > 1 && count_from_zero(numbers)) return true;
  // A row may have the same word in several columns, such as "NA".
  return std::set(names.begin(), names.end()).size() > numbers.size();
}

/// Whether a cell names the time. A comment in prose may have as many words as there are columns.
bool has_time(std::span<const std::string_view> cells) {
  return std::ranges::any_of(cells, [](std::string_view cell) {
    return cell == "t" || cell == "T" || cell.find("ime") != std::string_view::npos ||
           cell.find("sec") != std::string_view::npos ||
           cell.find("stamp") != std::string_view::npos;
  });
}

/// The cells of a comment if they are names, or units, of that many columns; else none. A comment
/// may have another separator than the rows.
Cells header_cells(const std::string& comment, char separator, std::size_t columns) {
  for (const char used : separators) {
    Cells cells = cells_of(comment, used);
    const auto filled = without_empty_end(cells);
    if (filled.size() != columns || !std::ranges::all_of(filled, is_name)) continue;
    if (used == separator || has_time(filled) || are_units(filled)) return cells;
  }
  return {};
}

std::vector<std::string> names_in(const Cells& cells, std::size_t count) {
  std::vector<std::string> names;
  std::ranges::transform(cells, std::back_inserter(names), without_doubled_quotes);
  names.resize(count);
  return names;
}

std::vector<std::string> units_in(const Cells& cells, std::size_t count) {
  std::vector<std::string> units(cells.begin(), cells.end());
  units.resize(count);
  return units;
}

/// The header in the comments, if they have one.
std::optional<CsvHeader> commented_header(const Sample& sample, char separator) {
  const Cells row = cells_of(sample.lines[0].text, separator);
  std::vector<std::string> units;
  for (std::size_t i = sample.comments.size(); i-- > 0;) {
    const Cells cells = header_cells(sample.comments[i], separator, without_empty_end(row).size());
    if (cells.empty()) continue;
    if (!are_units(cells)) return CsvHeader{names_in(cells, row.size()), units, 0};
    units = units_in(cells, row.size());
  }
  return std::nullopt;
}

/// The first column whose name another one has, too; the number of columns if there is none.
std::size_t first_doubled(const std::vector<std::string>& names) {
  std::map<std::string_view, std::size_t> columns;
  std::size_t first = names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) continue;
    const auto [found, is_new] = columns.emplace(names[i], i);
    if (!is_new) first = std::min(first, found->second);
  }
  return first;
}

}  // namespace

bool are_units(std::span<const std::string_view> cells) {
  const auto is_value = [](std::string_view cell) { return cell != "1" && is_numeric(cell); };
  return std::ranges::none_of(cells, is_value) && std::ranges::any_of(cells, is_known_unit);
}

void add_groups(const std::vector<std::string>& lines, char separator,
                std::vector<std::string>& names) {
  const std::size_t first = first_doubled(names);
  std::vector<std::string> longer = names;
  for (std::size_t i = lines.size(); first_doubled(longer) < names.size() && i-- > 0;) {
    const Cells cells = cells_of(lines[i], separator);
    if (cells.size() != names.size()) continue;
    std::string_view group;
    for (std::size_t column = 0; column < names.size(); ++column) {
      if (!cells[column].empty()) group = cells[column];
      const bool is_in_group = column >= first && !group.empty() && !longer[column].empty();
      if (is_in_group) longer[column] = fmt::format("{}: {}", group, longer[column]);
    }
  }
  if (first_doubled(longer) == names.size()) names = std::move(longer);
}

CsvHeader find_csv_header(const Sample& sample, char separator) {
  const Cells first = cells_of(sample.lines[0].text, separator);
  CsvHeader header;
  const auto commented = commented_header(sample, separator);
  if (commented && (are_units(first) || !is_header(sample, separator))) {
    header = *commented;
  } else if (is_header(sample, separator)) {
    header = {names_in(first, first.size()), {}, 1};
  } else {
    header.names = names_of_ros_message(first);
    for (std::size_t i = header.names.size(); i < first.size(); ++i)
      header.names.push_back(fmt::format("#{}", i + 1));
    return header;
  }
  if (header.first_row == sample.lines.size()) return header;
  const Cells next = cells_of(sample.lines[header.first_row].text, separator);
  if (!are_units(next)) return header;
  header.units = units_in(next, header.names.size());
  ++header.first_row;
  return header;
}

}  // namespace twrench::table
