#include "table/calendar_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "table/number_text.h"

namespace twrench::table {
namespace {

bool is_digit_of_time(char c) { return c >= '0' && c <= '9'; }

/// Takes a number of exactly `count` digits.
std::optional<int> take_digits(std::string_view& text, std::size_t count) {
  if (text.size() < count || !std::ranges::all_of(text.substr(0, count), is_digit_of_time))
    return std::nullopt;
  int number = 0;
  std::from_chars(text.data(), text.data() + count, number);
  text.remove_prefix(count);
  return number;
}

bool take_character(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

/// Takes "03-04" or "063", and returns the days since 1970.
std::optional<std::chrono::sys_days> take_day(std::string_view& text, std::chrono::year year) {
  using std::chrono::January;
  const std::size_t digits = text.size() > 2 && text[2] == '-' ? 2 : 3;
  const auto first = take_digits(text, digits);
  if (!first || !year.ok()) return std::nullopt;
  if (digits == 3) {
    const int most = year.is_leap() ? 366 : 365;
    if (*first < 1 || *first > most) return std::nullopt;
    return std::chrono::sys_days(year / January / 1) + std::chrono::days(*first - 1);
  }
  if (!take_character(text, '-')) return std::nullopt;
  const auto day = take_digits(text, 2);
  if (!day) return std::nullopt;
  const auto date = year / *first / *day;
  return date.ok() ? std::optional(std::chrono::sys_days(date)) : std::nullopt;
}

}  // namespace

bool read_calendar_time(std::string_view text, Number& number) {
  const auto year = take_digits(text, 4);
  if (!year || !take_character(text, '-')) return false;
  const auto day = take_day(text, std::chrono::year(*year));
  if (!day || !take_character(text, 'T')) return false;
  const auto hour = take_digits(text, 2);
  if (!hour || !take_character(text, ':')) return false;
  const auto minute = take_digits(text, 2);
  if (!minute || !take_character(text, ':')) return false;
  const auto second = take_digits(text, 2);
  constexpr int leap_second = 60;
  if (!second || *hour > 23 || *minute > 59 || *second > leap_second) return false;
  if (text.ends_with('Z')) text.remove_suffix(1);
  const std::string_view fraction = text;
  if (take_character(text, '.') && text.empty()) return false;
  if (!std::ranges::all_of(text, is_digit_of_time) ||
      (fraction.data() == text.data() && !text.empty()))
    return false;
  const std::chrono::seconds whole = day->time_since_epoch() + std::chrono::hours(*hour) +
                                     std::chrono::minutes(*minute) + std::chrono::seconds(*second);
  // The fraction of a time before 1970 counts the other way.
  if (whole.count() < 0 && text.find_first_not_of('0') != std::string_view::npos) return false;
  return read_number(fmt::format("{}{}", whole.count(), fraction), false, number) ==
         Reading::number;
}

}  // namespace twrench::table
