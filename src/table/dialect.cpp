#include "table/dialect.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "system/error.h"
#include "table/calendar.h"
#include "table/line_reader.h"
#include "table/number_text.h"

namespace twrench::table {
namespace {

constexpr std::size_t sample_lines = 32, kept_comments = 32;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// How well a separator explains the lines.
struct Fit {
  std::size_t equal = 0;  ///< lines with as many cells as the first
  double numeric = 0;     ///< the share of cells that are numbers, except in the first line
  bool operator<(const Fit& other) const {
    return equal != other.equal ? equal < other.equal : numeric < other.numeric;
  }
};

std::optional<Fit> fit_of(const Sample& sample, char separator) {
  Fit fit;
  std::size_t columns = 0, cell_count = 0, numbers = 0;
  std::vector<std::string_view> cells;
  for (const Sample::Line& line : sample.lines) {
    split_cells(line.text, separator, cells);
    const bool is_first = &line == &sample.lines.front();
    if (is_first) columns = cells.size();
    if (cells.size() == columns + 1 && cells.back().empty()) cells.pop_back();
    fit.equal += cells.size() == columns ? 1 : 0;
    if (is_first && sample.lines.size() > 1) continue;
    cell_count += cells.size();
    numbers += static_cast<std::size_t>(std::ranges::count_if(cells, is_numeric));
  }
  if (columns < 2) return std::nullopt;
  fit.numeric =
      static_cast<double>(numbers) / static_cast<double>(std::max<std::size_t>(cell_count, 1));
  return fit;
}

char separator_of(const Sample& sample) {
  char best = ',';
  std::optional<Fit> best_fit;
  for (const char separator : separators) {
    const std::optional<Fit> fit = fit_of(sample, separator);
    if (!fit || (best_fit && !(*best_fit < *fit))) continue;
    best = separator;
    best_fit = fit;
  }
  return best;
}

bool has_comma(std::string_view cell) { return cell.find(',') != std::string_view::npos; }

/// Whether the comma may as well group thousands: 1,234 but neither 0,234 nor 1,23.
bool may_group_thousands(std::string_view cell) {
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  const std::size_t comma = cell.find(',');
  return comma >= 1 && comma <= 3 && cell.front() != '0' && cell.size() == comma + 4 &&
         cell.find_first_of("eEdD") == std::string_view::npos;
}

bool has_decimal_commas(const Sample& sample, char separator, const std::string& file) {
  const Sample::Line* doubtful = nullptr;
  std::string doubtful_cell;
  std::vector<std::string_view> cells;
  for (const Sample::Line& line : sample.lines) {
    split_cells(line.text, separator, cells);
    for (const std::string_view cell : cells) {
      if (!has_comma(cell) || !is_numeric(cell)) continue;
      if (!may_group_thousands(cell)) return true;
      doubtful = &line;
      doubtful_cell = cell;
    }
  }
  if (!doubtful) return false;
  throw system::FileError(
      fmt::format("{}:{}", file, doubtful->number),
      fmt::format("'{}' may have a decimal comma, or one that groups thousands", doubtful_cell),
      "write numbers with a decimal point and without groups");
}

/// Returns the cell whose quotation mark is at `at`, and moves `at` past the closing one.
std::string_view take_quoted(std::string_view line, std::size_t& at, bool& closed) {
  const std::size_t first = at + 1;
  std::size_t end = first;
  while (true) {
    end = line.find('"', end);
    closed = end != std::string_view::npos;
    if (!closed) {
      at = line.size();
      return line.substr(first);
    }
    if (end + 1 >= line.size() || line[end + 1] != '"') break;
    end += 2;  // "" is a quotation mark of the text
  }
  at = end + 1;
  return line.substr(first, end - first);
}

/// Whether semicolons separate cells: the first line that no mark makes a comment has one, or all
/// lines begin with one.
bool has_semicolons_between_cells(const Input& input, std::size_t skipped) {
  LineReader lines(input);
  for (std::string_view line; lines.next(line);) {
    if (lines.number() <= skipped) continue;
    if (!is_blank_or_comment(line, true)) return line.find(';') != std::string_view::npos;
  }
  return true;
}

/// The text of a comment after its mark, which may be repeated.
std::string without_mark(std::string_view comment) {
  const std::size_t first = comment.find_first_not_of("#%/;");
  return std::string(first == std::string_view::npos ? "" : trimmed(comment.substr(first)));
}

/// Joins the cells of a date that has blanks around its month's name: 01 Jan 2026 12:00:00.
void join_dates(std::vector<std::string_view>& cells) {
  for (std::size_t month = 1; month + 1 < cells.size(); ++month) {
    const bool begins_with_letter = !cells[month].empty() && cells[month].front() >= 'A';
    if (!begins_with_letter || cells[month - 1].empty()) continue;
    const char* const begin = cells[month - 1].data();
    for (const std::size_t last : {std::min(month + 2, cells.size() - 1), month + 1}) {
      const char* const end = cells[last].data() + cells[last].size();
      const std::string_view date(begin, static_cast<std::size_t>(end - begin));
      Number number;
      if (read_calendar(date, number, DateOrder::day_first) == Calendar::none) continue;
      cells[month - 1] = date;
      const auto next = cells.begin() + static_cast<std::ptrdiff_t>(month);
      cells.erase(next, next + static_cast<std::ptrdiff_t>(last - month + 1));
      break;
    }
  }
}

}  // namespace

bool is_blank_or_comment(std::string_view line, bool semicolon_marks_comment) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.front() == '#' || text.front() == '%' || text.starts_with("//") ||
         (semicolon_marks_comment && text.front() == ';');
}

Sample read_sample(const Input& input, std::size_t skipped) {
  Sample sample;
  sample.semicolon_marks_comment = !has_semicolons_between_cells(input, skipped);
  LineReader lines(input);
  for (std::string_view line; sample.lines.size() < sample_lines && lines.next(line);) {
    if (lines.number() <= skipped) continue;
    const std::string_view text = trimmed(line);
    if (!is_blank_or_comment(line, sample.semicolon_marks_comment)) {
      sample.lines.push_back({std::string(line), lines.number()});
    } else if (!text.empty() && sample.lines.empty()) {
      sample.comments.push_back(without_mark(text));
      if (sample.comments.size() > kept_comments) sample.comments.erase(sample.comments.begin());
    }
  }
  return sample;
}

Dialect detect_dialect(const Sample& sample, const std::string& file) {
  const char separator = separator_of(sample);
  return {separator, has_decimal_commas(sample, separator, file)};
}

bool split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  bool closed = true;
  std::size_t at = 0;
  while (true) {
    while (at < line.size() && is_blank(line[at]) && line[at] != separator) ++at;
    while (separator == ' ' && at < line.size() && is_blank(line[at])) ++at;
    if (separator == ' ' && at == line.size()) break;
    const bool quoted = at < line.size() && line[at] == '"';
    std::string_view cell = quoted ? take_quoted(line, at, closed) : std::string_view{};
    std::size_t end = separator == ' ' ? line.find_first_of(" \t", at) : line.find(separator, at);
    if (end == std::string_view::npos) end = line.size();
    cells.push_back(quoted ? cell : trimmed(line.substr(at, end - at)));
    if (end == line.size()) break;
    at = end + 1;
  }
  if (separator == ' ') join_dates(cells);
  return closed;
}

bool is_numeric(std::string_view cell) {
  Number number;
  return read_number(cell, false, number) != Reading::text ||
         (has_comma(cell) && read_number(cell, true, number) != Reading::text);
}

}  // namespace twrench::table
