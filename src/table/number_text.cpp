#include "table/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>

namespace twrench::table {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_digit_or_point(char c) { return is_digit(c) || c == '.'; }

/// The exponent in a text such as "e-07"; 0 if the text is empty. Clamped to +-9999, beyond which
/// it does not matter.
int exponent_of(std::string_view text) {
  if (text.empty()) return 0;
  text.remove_prefix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  int exponent = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), exponent);
  const int beyond = text.starts_with('-') ? -9999 : 9999;
  return read.ec == std::errc{} ? std::clamp(exponent, -9999, 9999) : beyond;
}

/// The digits * 10^-decimals minus `value`, the nearest double. Each product is split into two
/// doubles without rounding, because the difference has few digits left.
double rest_of(std::uint64_t digits, int decimals, double value) {
  static const std::array<double, 23> powers = [] {
    std::array<double, 23> list{1};
    for (std::size_t i = 1; i < list.size(); ++i) list[i] = 10 * list[i - 1];  // exact up to 10^22
    return list;
  }();
  if (std::abs(decimals) > 22) return 0;
  const auto high = static_cast<double>(digits);
  const auto low =
      static_cast<double>(static_cast<std::int64_t>(digits - static_cast<std::uint64_t>(high)));
  const double power = powers[static_cast<std::size_t>(std::abs(decimals))];
  const double factor = decimals < 0 ? high : value;
  const double product = factor * power, error = std::fma(factor, power, -product);
  if (decimals < 0) return (product - value) + (error + low * power);
  return ((high - product) - error + low) / power;
}

/// Counts the digits of a text that is a number, and sets the rest.
void count_digits(std::string_view text, Number& number) {
  int decimals = 0, significant = 0;
  std::uint64_t digits = 0;
  bool behind_point = false;
  std::size_t i = text.starts_with('-') ? 1 : 0;
  for (; i < text.size() && is_digit_or_point(text[i]); ++i) {
    if (text[i] == '.') {
      behind_point = true;
      continue;
    }
    decimals += behind_point ? 1 : 0;
    significant += significant > 0 || text[i] != '0' ? 1 : 0;
    digits = 10 * digits + static_cast<std::uint64_t>(text[i] - '0');
  }
  number.decimals = decimals - exponent_of(text.substr(i));
  number.significant = significant;
  constexpr int most = 19;  // digits that 64 bits can hold
  if (significant == 0 || significant > most) return;
  const double rest = rest_of(digits, number.decimals, std::abs(number.value));
  number.rest = text.starts_with('-') ? -rest : rest;
}

/// Whether a number out of the range of doubles is too small rather than too large.
bool is_tiny(std::string_view text) {
  Number digits;
  count_digits(text, digits);
  return digits.significant - digits.decimals < 0;
}

Reading read_plain(std::string_view text, Number& number) {
  number.rest = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number.value);
  if (stop != end || error == std::errc::invalid_argument) return Reading::text;
  if (error == std::errc::result_out_of_range) {
    if (!is_tiny(text)) return Reading::too_large;
    number.value = 0;
  }
  if (std::isfinite(number.value)) count_digits(text, number);
  return Reading::number;
}

}  // namespace

Reading read_number(std::string_view text, bool decimal_comma, Number& number) {
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  if (!decimal_comma) {
    const Reading reading = read_plain(text, number);
    // Copies the text only if it may have Fortran's exponent.
    if (reading != Reading::text || text.find_first_of("dD") == std::string_view::npos) {
      return reading;
    }
  } else if (text.find('.') != std::string_view::npos) {
    return Reading::text;
  }
  std::string plain(text);
  if (decimal_comma) std::ranges::replace(plain, ',', '.');
  const std::size_t exponent = plain.find_first_of("dD");
  if (exponent != std::string::npos && exponent > 0 && is_digit_or_point(plain[exponent - 1])) {
    plain[exponent] = 'e';
  }
  return read_plain(plain, number);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

}  // namespace twrench::table
