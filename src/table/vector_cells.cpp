#include "table/vector_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/words.h"
#include "table/dialect.h"
#include "table/line_reader.h"

namespace twrench::table {
namespace {

/// Splits a line at the separators that are neither in brackets nor in quotation marks.
std::vector<std::string_view> cells_outside_brackets(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  std::size_t begin = 0;
  int depth = 0;
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') is_quoted = !is_quoted;
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (c != separator || is_quoted || depth > 0) continue;
    cells.push_back(trimmed(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  cells.push_back(trimmed(line.substr(begin)));
  return cells;
}

std::string_view without_quotes(std::string_view cell) {
  const bool is_quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return is_quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

/// The numbers between brackets, which commas or blanks separate; empty if the cell has none.
std::vector<std::string_view> numbers_in_brackets(std::string_view cell) {
  cell = without_quotes(cell);
  const bool has_brackets = cell.size() > 1 && ((cell.front() == '(' && cell.back() == ')') ||
                                                (cell.front() == '[' && cell.back() == ']'));
  if (!has_brackets) return {};
  const std::string_view inside = cell.substr(1, cell.size() - 2);
  const auto commas = std::ranges::count(inside, ',');
  std::ptrdiff_t followed_by_blank = 0;
  for (std::size_t at = inside.find(", "); at != std::string_view::npos;
       at = inside.find(", ", at + 1)) {
    ++followed_by_blank;
  }
  // Otherwise some are decimal commas, as in (0,1, 0,2, 0,3).
  const bool are_separators = followed_by_blank == 0 || followed_by_blank == commas;
  std::vector<std::string_view> numbers;
  if (are_separators) split_cells(inside, commas > 0 ? ',' : ' ', numbers);
  return numbers;
}

/// The size of the vector in a cell; 0 if it is none.
std::size_t size_of_vector(std::string_view cell) {
  const std::vector<std::string_view> numbers = numbers_in_brackets(cell);
  constexpr std::array<std::size_t, 3> sizes{3, 4, 9};  // vectors, quaternions and matrices
  const bool is_vector = std::ranges::find(sizes, numbers.size()) != sizes.end() &&
                         std::ranges::all_of(numbers, is_numeric);
  return is_vector ? numbers.size() : 0;
}

/// The columns of a text with vectors in its cells.
struct VectorColumns {
  char separator;
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;  ///< 0 for columns without vectors
};

bool is_passed_over(std::string_view line, char separator) {
  return is_blank_or_comment(line, separator != ';');
}

/// The next line that is neither blank nor a comment; empty at the end.
std::string next_line(LineReader& lines, char separator) {
  for (std::string_view line; lines.next(line);) {
    if (!is_passed_over(line, separator)) return std::string(line);
  }
  return {};
}

/// The sizes of the vectors in each column; the first rows may lack some.
std::vector<std::size_t> sizes_in_first_rows(LineReader& lines, char separator,
                                             std::size_t columns) {
  constexpr int rows = 64;
  std::vector<std::size_t> sizes(columns, 0);
  for (int row = 0; row < rows; ++row) {
    const std::string line = next_line(lines, separator);
    const auto cells = cells_outside_brackets(line, separator);
    if (cells.size() != columns) break;
    for (std::size_t i = 0; i < columns; ++i)
      sizes[i] = std::max(sizes[i], size_of_vector(cells[i]));
  }
  return sizes;
}

std::optional<VectorColumns> columns_with_vectors(const Input& input) {
  for (const char separator : {'\t', ';', '|', ','}) {
    LineReader lines(input);
    VectorColumns columns{separator, {}, {}};
    const std::string names = next_line(lines, separator);
    for (const std::string_view cell : cells_outside_brackets(names, separator))
      columns.names.emplace_back(without_quotes(cell));
    columns.sizes = sizes_in_first_rows(lines, separator, columns.names.size());
    const bool has_vectors =
        std::ranges::any_of(columns.sizes, [](std::size_t size) { return size > 0; });
    if (has_vectors) return columns;
  }
  return std::nullopt;
}

std::string expanded_names(const VectorColumns& columns) {
  std::string line;
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    if (i > 0) line += columns.separator;
    if (columns.sizes[i] == 0) line += fmt::format("\"{}\"", columns.names[i]);
    for (std::size_t k = 0; k < columns.sizes[i]; ++k) {
      if (k > 0) line += columns.separator;
      line += fmt::format("\"{}[{}]\"", columns.names[i], k);
    }
  }
  return line;
}

/// The numbers of a vector as cells. If it has others, the first cell has its text, which is an
/// error only where its column is read.
std::string expanded_cell(std::string_view cell, std::size_t size, char separator) {
  const std::vector<std::string_view> numbers = numbers_in_brackets(cell);
  const bool is_other = numbers.size() != size;
  std::string text = is_other && !cell.empty() ? fmt::format("\"{}\"", without_quotes(cell)) : "";
  for (std::size_t k = 0; k < size; ++k) {
    if (k > 0) text += separator;
    if (!is_other) text += numbers[k];
  }
  return text;
}

}  // namespace

std::optional<Input> table_of_vector_cells(const Input& input) {
  const std::optional<VectorColumns> columns = columns_with_vectors(input);
  if (!columns) return std::nullopt;
  auto text = std::make_shared<std::string>();
  bool has_names = false;
  LineReader lines(input);
  for (std::string_view line; lines.next(line); *text += '\n') {
    const auto cells = cells_outside_brackets(line, columns->separator);
    const bool is_row = has_names && cells.size() == columns->sizes.size();
    if (is_passed_over(line, columns->separator) || (has_names && !is_row)) {
      *text += line;
    } else if (!has_names) {
      *text += expanded_names(*columns);
      has_names = true;
    } else {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t size = columns->sizes[i];
        if (i > 0) *text += columns->separator;
        if (size == 0) *text += cells[i];
        if (size > 0) *text += expanded_cell(cells[i], size, columns->separator);
      }
    }
  }
  return Input(input.name(), std::shared_ptr<const std::string>(std::move(text)));
}

}  // namespace twrench::table
