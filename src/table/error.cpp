#include "table/error.h"

#include <fmt/format.h>

namespace twrench::table {
namespace {

/// The text for a message, shortened because a cell may be as long as a file.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  return text.size() <= longest ? fmt::format("'{}'", text)
                                : fmt::format("'{}...'", text.substr(0, longest));
}

}  // namespace

std::string cell_place(const std::string& row_place, const std::string& column) {
  return fmt::format("{}: the column {}", row_place, shown(column));
}

BadTable no_number(const std::string& row_place, const std::string& column, std::string_view text) {
  return {cell_place(row_place, column), fmt::format("{} is no number", shown(text)),
          "correct or remove the row, or choose another column"};
}

BadTable too_large(const std::string& row_place, const std::string& column, std::string_view text) {
  return {cell_place(row_place, column),
          fmt::format("{} is beyond what a double can hold", shown(text)),
          "correct or remove the row"};
}

BadTable no_calendar_time(const std::string& row_place, const std::string& column,
                          std::string_view text) {
  return {cell_place(row_place, column),
          fmt::format("{} is no calendar time of the form in the first row", shown(text)),
          "write all times as 2026-03-04T10:11:05.25, with at most nine decimals"};
}

}  // namespace twrench::table
