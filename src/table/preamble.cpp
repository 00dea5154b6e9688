#include "table/preamble.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "table/csv_header.h"
#include "table/dialect.h"
#include "table/line_reader.h"

namespace twrench::table {
namespace {

/// A longer preamble is not searched for.
constexpr std::size_t most_lines = 256;

std::vector<std::string> first_lines(const Input& input) {
  LineReader reader(input);
  std::vector<std::string> lines;
  for (std::string_view line; lines.size() < most_lines && reader.next(line);) {
    lines.emplace_back(line);
  }
  return lines;
}

/// Whether the letters of the line are "endheader" or "endofheader".
bool is_end_of_header(std::string_view line) {
  std::string letters;
  for (const char c : line) {
    if (c >= 'a' && c <= 'z') letters += c;
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
  }
  return letters == "endheader" || letters == "endofheader";
}

std::size_t count_numbers(const std::vector<std::string_view>& cells) {
  return static_cast<std::size_t>(std::ranges::count_if(cells, is_numeric));
}

/// Whether all cells are different names.
bool are_names(const std::vector<std::string_view>& cells) {
  const bool are_words = std::ranges::all_of(
      cells, [](std::string_view cell) { return !cell.empty() && !is_numeric(cell); });
  return are_words && std::set(cells.begin(), cells.end()).size() == cells.size();
}

using Lines = std::vector<std::vector<std::string_view>>;

constexpr std::size_t least_numbers = 2;

/// Whether the line may be a row of the table of this row: it has numbers, the first cell among
/// them, and wherever the row has one, a number or nothing.
bool may_be_row(const std::vector<std::string_view>& line,
                const std::vector<std::string_view>& row) {
  for (std::size_t i = 0; i < std::min(line.size(), row.size()); ++i) {
    if (is_numeric(row[i]) && !line[i].empty() && !is_numeric(line[i])) return false;
  }
  const bool lacks_first = is_numeric(row.front()) && line.front().empty();
  return !lacks_first && count_numbers(line) >= least_numbers;
}

/// Index of the line of names below lines of as many cells, which have names of groups of columns:
/// the last before the rows and, if there is one, their line of units. 0 if there is none.
std::size_t line_below_groups(const Lines& cells, std::size_t first) {
  std::size_t rows = cells.size();
  while (rows > first && count_numbers(cells[rows - 1]) >= least_numbers) --rows;
  if (rows == first || rows == cells.size()) return 0;
  std::size_t names = rows - 1;
  if (names > first && are_units(cells[names])) --names;
  constexpr std::size_t least_names = 3;
  std::size_t count = 0;
  for (const std::string_view cell : cells[names]) {
    if (is_numeric(cell)) return 0;
    count += cell.empty() ? 0 : 1;
  }
  return names > first && count >= least_names ? names : 0;
}

/// Index of the line of names that follows other lines and precedes rows, in lines that the
/// separator divides; 0 if there is none. No line before it may look like a row.
std::size_t line_of_names(const std::vector<Sample::Line>& lines, char separator) {
  constexpr std::size_t least_columns = 3, least_rows = 2;
  Lines cells(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) split_cells(lines[i].text, separator, cells[i]);
  const std::size_t columns = cells.back().size();
  std::size_t names = lines.size();
  while (names > 0 && cells[names - 1].size() == columns) --names;
  if (columns < least_columns || names + least_rows >= lines.size()) return 0;
  const bool are_unique = are_names(cells[names]);
  const bool has_rows_below = count_numbers(cells[names + 1]) >= least_numbers;
  if (are_unique && !has_rows_below) return 0;  // names, and a row of words
  if (!are_unique) names = line_below_groups(cells, names);
  const bool has_row_before =
      std::any_of(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(names),
                  [&](const auto& line) { return may_be_row(line, cells.back()); });
  return has_row_before ? 0 : names;
}

}  // namespace

std::vector<std::string> find_preamble(const Input& input) {
  std::vector<std::string> lines = first_lines(input);
  const auto last_end = std::find_if(lines.rbegin(), lines.rend(), is_end_of_header);
  if (last_end != lines.rend()) {
    lines.erase(last_end.base(), lines.end());
    return lines;
  }
  const std::size_t skipped = !lines.empty() && lines[0].starts_with("sep=") ? 1 : 0;
  const Sample sample = read_sample(input, skipped);
  std::size_t count = skipped;
  for (const char separator : separators) {
    if (sample.lines.empty() || count > skipped) break;
    const std::size_t names = line_of_names(sample.lines, separator);
    if (names > 0) count = sample.lines[names].number - 1;
  }
  lines.resize(std::min(count, lines.size()));
  return lines;
}

}  // namespace twrench::table
