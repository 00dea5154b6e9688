#include "interchange/epoch.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace twrench::interchange {
namespace {

namespace chrono = std::chrono;

constexpr std::string_view pattern = "0000-00-00T00:00:00";

bool matches_pattern(const std::string& text) {
  return std::ranges::equal(text, pattern, [](char c, char expected) {
    return expected == '0' ? c >= '0' && c <= '9' : c == expected;
  });
}

int number_at(const std::string& text, std::size_t begin, std::size_t count) {
  int number = 0;
  std::from_chars(text.data() + begin, text.data() + begin + count, number);
  return number;
}

}  // namespace

Epoch parse_epoch(const std::string& text, const std::string& what) {
  const auto refuse = [&](const char* why) {
    return InvalidArgument(what, fmt::format("is {}, but {}", text, why));
  };
  if (!matches_pattern(text)) throw refuse("must have the form 2026-01-01T00:00:00");
  const chrono::year_month_day day{chrono::year(number_at(text, 0, 4)),
                                   chrono::month(static_cast<unsigned>(number_at(text, 5, 2))),
                                   chrono::day(static_cast<unsigned>(number_at(text, 8, 2)))};
  const int hour = number_at(text, 11, 2), minute = number_at(text, 14, 2),
            second = number_at(text, 17, 2);
  if (!day.ok() || day.year() < chrono::year(1)) throw refuse("there is no such day");
  if (hour > 23 || minute > 59 || second > 59) throw refuse("there is no such time of day");
  return chrono::sys_days(day) + chrono::hours(hour) + chrono::minutes(minute) +
         chrono::seconds(second);
}

std::string format_epoch(Epoch epoch, std::int64_t ticks, int digits) {
  std::int64_t in_a_second = 1;
  for (int i = 0; i < digits; ++i) in_a_second *= 10;
  const Epoch instant = epoch + chrono::seconds(ticks / in_a_second);
  const auto midnight = chrono::floor<chrono::days>(instant);
  const chrono::year_month_day day(midnight);
  if (day.year() > chrono::year(9999)) {
    throw InvalidArgument("epoch", "the motion would last beyond the year 9999");
  }
  const auto seconds = (instant - midnight).count();
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:0{}}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()),
                     seconds / 3600, seconds / 60 % 60, seconds % 60, ticks % in_a_second, digits);
}

}  // namespace twrench::interchange
