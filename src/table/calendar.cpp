#include "table/calendar.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "base/words.h"
#include "table/number_text.h"

namespace twrench::table {
namespace {

constexpr long long nanoseconds_in_second = 1'000'000'000;
constexpr int most_decimals = 9;

/// Takes parts of a text from its beginning.
class Parts {
 public:
  explicit Parts(std::string_view text) : text_(text) {}

  bool is_at_end() const { return text_.empty(); }

  bool take(std::string_view any_of) {
    const bool is_there = !text_.empty() && any_of.find(text_.front()) != std::string_view::npos;
    if (is_there) text_.remove_prefix(1);
    return is_there;
  }

  /// Takes all digits that follow.
  std::string_view take_digits() {
    const std::size_t end = std::min(text_.find_first_not_of("0123456789"), text_.size());
    const std::string_view digits = text_.substr(0, end);
    text_.remove_prefix(end);
    return digits;
  }

  /// Takes a number of exactly that many digits, the last of which is `most` or less.
  std::optional<int> take_number(std::size_t count, int most) {
    const std::string_view digits = text_.substr(0, count);
    if (digits.size() < count || digits.find_first_not_of("0123456789") != std::string_view::npos) {
      return std::nullopt;
    }
    text_.remove_prefix(count);
    int number = 0;
    for (const char digit : digits) number = 10 * number + (digit - '0');
    return number <= most ? std::optional(number) : std::nullopt;
  }

  /// Takes a number of one or two digits.
  std::optional<int> take_short_number(int most) {
    return take_number(begins_with_number_of(1) ? 1 : 2, most);
  }

  /// Takes all letters that follow.
  std::string_view take_letters() {
    std::size_t end = 0;
    while (end < text_.size() &&
           ((text_[end] >= 'A' && text_[end] <= 'Z') || (text_[end] >= 'a' && text_[end] <= 'z')))
      ++end;
    const std::string_view letters = text_.substr(0, end);
    text_.remove_prefix(end);
    return letters;
  }

  bool begins_with_number_of(std::size_t count) const {
    return std::min(text_.find_first_not_of("0123456789"), text_.size()) == count;
  }

 private:
  std::string_view text_;
};

/// Days since 1970; nothing if there is no such date.
std::optional<long long> days_of(int year, int month, int day) {
  const std::chrono::year_month_day date =
      std::chrono::year(year) / static_cast<unsigned>(month) / static_cast<unsigned>(day);
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

/// The number of the month from the beginning of its English name; 0 if it is none.
int month_named(std::string_view name) {
  constexpr std::string_view months = "janfebmaraprmayjunjulaugsepoctnovdec";
  const std::string small = to_lower(name.substr(0, 3));
  const std::size_t at = small.size() == 3 ? months.find(small) : std::string_view::npos;
  return at != std::string_view::npos && at % 3 == 0 ? static_cast<int>(at / 3) + 1 : 0;
}

/// A date that ends with its year: 28/11/2026, 28.11.2026, 28 Nov 2026.
struct LateYear {
  int first = 0, second = 0, year = 0;
  DateOrder order = DateOrder::open;  ///< as it states it itself
};

std::optional<LateYear> take_late_year(Parts& parts) {
  LateYear date;
  const auto first = parts.take_short_number(31);
  if (!first) return std::nullopt;
  const bool has_points = parts.take(".");
  if (!has_points && !parts.take("/- ")) return std::nullopt;
  const int named = month_named(parts.take_letters());
  const auto second = named > 0 ? std::optional(named) : parts.take_short_number(31);
  if (!second || !parts.take(has_points ? "." : "/- ")) return std::nullopt;
  const auto year = parts.take_number(4, 9999);
  if (!year || *first == 0 || *second == 0) return std::nullopt;
  date = {*first, *second, *year, DateOrder::open};
  constexpr int months = 12;
  if (named > 0 || has_points || *first > months) date.order = DateOrder::day_first;
  if (*second > months) date.order = DateOrder::month_first;
  return date;
}

/// Days since 1970.
std::optional<long long> take_date(Parts& parts, DateOrder order) {
  if (!parts.begins_with_number_of(4) && !parts.begins_with_number_of(8)) {
    const auto date = take_late_year(parts);
    if (!date) return std::nullopt;
    if (order == DateOrder::open) order = date->order;
    const bool contradicts = date->order != DateOrder::open && date->order != order;
    if (order == DateOrder::open || contradicts) return std::nullopt;
    return order == DateOrder::day_first ? days_of(date->year, date->second, date->first)
                                         : days_of(date->year, date->first, date->second);
  }
  const bool is_compact = parts.begins_with_number_of(8);
  const auto year = parts.take_number(4, 9999);
  if (!year || !(is_compact || parts.take("-/ "))) return std::nullopt;
  if (!is_compact && parts.begins_with_number_of(3)) {
    const auto day = parts.take_number(3, 366);
    const std::chrono::year in_year(*year);
    if (!day || *day == 0 || (*day == 366 && !in_year.is_leap())) return std::nullopt;
    const std::chrono::sys_days first = in_year / 1 / 1;
    return first.time_since_epoch().count() + *day - 1;
  }
  const int named = is_compact ? 0 : month_named(parts.take_letters());
  const auto month = named > 0 ? std::optional(named) : parts.take_number(2, 12);
  if (!month || !(is_compact || parts.take(named > 0 ? "-/ " : "-/"))) return std::nullopt;
  const auto day = parts.take_number(2, 31);
  return day ? days_of(*year, *month, *day) : std::nullopt;
}

/// A time of a day.
struct Clock {
  long long nanoseconds = 0;
  int decimals = 0;
};

/// The fraction of a second behind its point.
bool take_fraction(Parts& parts, Clock& clock) {
  std::string_view digits = parts.take_digits();
  if (digits.empty()) return false;
  while (digits.size() > most_decimals && digits.back() == '0') digits.remove_suffix(1);
  if (digits.size() > most_decimals) return false;
  long long fraction = 0;
  for (std::size_t i = 0; i < most_decimals; ++i) {
    fraction = 10 * fraction + (i < digits.size() ? digits[i] - '0' : 0);
  }
  clock.nanoseconds += fraction;
  clock.decimals = static_cast<int>(digits.size());
  return true;
}

/// Takes AM or PM, and returns the hour of the day; nothing if the hour is not from 1 to 12.
std::optional<int> take_half_of_day(Parts& parts, int hour) {
  Parts after = parts;
  after.take(" ");
  const std::string half = to_lower(after.take_letters());
  if (half != "am" && half != "pm") return hour;
  parts = after;
  if (hour < 1 || hour > 12) return std::nullopt;
  return hour % 12 + (half == "pm" ? 12 : 0);
}

std::optional<Clock> take_clock(Parts& parts) {
  const bool is_compact = parts.begins_with_number_of(6) || parts.begins_with_number_of(4);
  const auto hour = is_compact ? parts.take_number(2, 23) : parts.take_short_number(23);
  if (!hour || !(is_compact || parts.take(":"))) return std::nullopt;
  const auto minute = parts.take_number(2, 59);
  if (!minute) return std::nullopt;
  std::optional<int> second = 0;
  const bool has_second = is_compact ? parts.begins_with_number_of(2) : parts.take(":");
  if (has_second) second = parts.take_number(2, 60);
  if (!second) return std::nullopt;
  Clock clock{*second * nanoseconds_in_second, 0};
  // Physics Toolbox writes milliseconds behind a colon; a number of two digits would count frames.
  const bool has_milliseconds = has_second && parts.take(":");
  if (has_milliseconds && !parts.begins_with_number_of(3)) return std::nullopt;
  const bool has_fraction = has_milliseconds || (has_second && parts.take(".,"));
  if (has_fraction && !take_fraction(parts, clock)) return std::nullopt;
  const auto hour_of_day = take_half_of_day(parts, *hour);
  if (!hour_of_day) return std::nullopt;
  clock.nanoseconds += 60LL * (60 * *hour_of_day + *minute) * nanoseconds_in_second;
  return clock;
}

/// The offset from UTC in s; 0 if there is none.
std::optional<long long> take_offset(Parts& parts) {
  if (parts.is_at_end() || parts.take("Zz")) return 0;
  Parts named = parts;
  const std::string zone = to_lower(named.take_letters());
  if (zone == "utc" || zone == "gmt") {
    parts = named;
    return 0;
  }
  const bool is_west = parts.take("-");
  if (!is_west && !parts.take("+")) return std::nullopt;
  const auto hours = parts.take_number(2, 23);
  if (!hours) return std::nullopt;
  parts.take(":");
  const auto minutes = parts.is_at_end() ? std::optional(0) : parts.take_number(2, 59);
  if (!minutes) return std::nullopt;
  return (is_west ? -60LL : 60LL) * (60 * *hours + *minutes);
}

}  // namespace

Number seconds_from(long long nanoseconds, int decimals) {
  const long long size = std::abs(nanoseconds);
  std::string text = fmt::format("{}{}.{:09}", nanoseconds < 0 ? "-" : "",
                                 size / nanoseconds_in_second, size % nanoseconds_in_second);
  text.resize(text.size() - static_cast<std::size_t>(most_decimals - decimals));
  if (text.back() == '.') text.pop_back();
  Number number;
  read_number(text, false, number);
  return number;
}

DateOrder stated_order(std::string_view text) {
  Parts parts(text);
  if (parts.begins_with_number_of(4) || parts.begins_with_number_of(8)) return DateOrder::open;
  const auto date = take_late_year(parts);
  return date ? date->order : DateOrder::open;
}

Calendar read_calendar(std::string_view text, Number& number, DateOrder order) {
  Parts parts(text);
  if (text.size() > 2 && text.substr(0, 3).find(':') != std::string_view::npos) {
    const auto clock = take_clock(parts);
    if (!clock || !parts.is_at_end()) return Calendar::none;
    number = seconds_from(clock->nanoseconds, clock->decimals);
    return Calendar::time_of_day;
  }
  const auto days = take_date(parts, order);
  if (!days) return Calendar::none;
  constexpr long long seconds_in_day = 86400;
  constexpr long long most_days = 100'000;  // the nanoseconds since 1970 fit into 64 bits
  if (std::abs(*days) > most_days) return Calendar::none;
  const long long midnight = *days * seconds_in_day * nanoseconds_in_second;
  if (parts.is_at_end()) {
    number = seconds_from(midnight, 0);
    return Calendar::date;
  }
  if (!parts.take("Tt ")) return Calendar::none;
  const auto clock = take_clock(parts);
  if (!clock) return Calendar::none;
  parts.take(" ");
  const auto offset = take_offset(parts);
  if (!offset || !parts.is_at_end()) return Calendar::none;
  number = seconds_from(midnight + clock->nanoseconds - *offset * nanoseconds_in_second,
                        clock->decimals);
  return Calendar::date_time;
}

std::string calendar_text(Calendar calendar, const Number& number) {
  const int decimals = std::clamp(number.decimals, 0, most_decimals);
  double whole = std::floor(number.value);
  const double unit = std::pow(10.0, -decimals);
  double fraction = std::nearbyint(((number.value - whole) + number.rest) / unit) * unit;
  if (fraction >= 1) {
    whole += 1;
    fraction = 0;
  }
  const auto seconds = static_cast<long long>(whole);
  const std::chrono::sys_seconds time{std::chrono::seconds(seconds)};
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const long long of_day = (time - day).count();
  std::string text;
  if (calendar != Calendar::time_of_day) {
    text = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  }
  if (calendar == Calendar::date_time) text += 'T';
  if (calendar == Calendar::date) return text;
  text += fmt::format("{:02}:{:02}:{:02}", of_day / 3600, of_day / 60 % 60, of_day % 60);
  if (decimals > 0) text += fmt::format("{:.{}f}", fraction, decimals).substr(1);
  return text;
}

}  // namespace twrench::table
