#include "table/preamble.h"

#include <algorithm>
#include <set>
#include <string_view>

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

/// Index of the line of names that follows lines of fewer cells and precedes rows, in lines that
/// the separator divides; 0 if there is none. No line before it may look like a row.
std::size_t line_of_names(const std::vector<Sample::Line>& lines, char separator) {
  constexpr std::size_t least_columns = 3, least_rows = 2, least_numbers = 2;
  std::vector<std::vector<std::string_view>> cells(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) split_cells(lines[i].text, separator, cells[i]);
  const std::size_t columns = cells.back().size();
  std::size_t names = lines.size();
  while (names > 0 && cells[names - 1].size() == columns) --names;
  const bool has_table = columns >= least_columns && names + least_rows < lines.size() &&
                         are_names(cells[names]) &&
                         count_numbers(cells[names + 1]) >= least_numbers;
  if (!has_table) return 0;
  const bool has_row_before =
      std::any_of(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(names),
                  [](const auto& line) { return count_numbers(line) >= least_numbers; });
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
