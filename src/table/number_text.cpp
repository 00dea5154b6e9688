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

/// The digits of a number, as they are written without its sign.
struct Decimal {
  std::uint64_t digits = 0;  ///< modulo 2^64
  int decimals = 0, significant = 0;
  bool is_plain = false;  ///< the text has only digits and at most one point
};

Decimal read_digits(std::string_view text) {
  Decimal decimal;
  std::size_t at = 0;
  const auto take_digits = [&] {
    const std::size_t begin = at;
    for (; at < text.size() && is_digit(text[at]); ++at) {
      decimal.digits = 10 * decimal.digits + static_cast<std::uint64_t>(text[at] - '0');
    }
    return static_cast<int>(at - begin);
  };
  const int whole = take_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    decimal.decimals = take_digits();
  }
  int zeros = 0;  // before the first nonzero digit
  for (std::size_t i = 0; i < at && (text[i] == '0' || text[i] == '.'); ++i) {
    zeros += text[i] == '0' ? 1 : 0;
  }
  decimal.significant = whole + decimal.decimals - zeros;
  decimal.is_plain = at == text.size() && whole + decimal.decimals > 0;
  decimal.decimals -= exponent_of(text.substr(at));
  return decimal;
}

/// A number that is the sum of two doubles.
struct Sum {
  double high, low;
};

/// digits * 10^-decimals for up to 22 decimals, before or behind the point, with twice the digits
/// of a double: the error of a product or quotient of two doubles is a double, too.
Sum scaled(std::uint64_t digits, int decimals) {
  static const std::array<double, 23> powers = [] {
    std::array<double, 23> list{1};
    for (std::size_t i = 1; i < list.size(); ++i) list[i] = 10 * list[i - 1];  // exact up to 10^22
    return list;
  }();
  const auto high = static_cast<double>(digits);
  const auto low =
      static_cast<double>(static_cast<std::int64_t>(digits - static_cast<std::uint64_t>(high)));
  const double power = powers[static_cast<std::size_t>(std::abs(decimals))];
  const double scaled = decimals < 0 ? high * power : high / power;
  if (decimals < 0) return {scaled, std::fma(high, power, -scaled) + low * power};
  return {scaled, (std::fma(-scaled, power, high) + low) / power};
}

/// Sets the value by std::from_chars.
Reading read_by_library(std::string_view text, const Decimal& decimal, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number.value);
  if (stop != end || error == std::errc::invalid_argument) return Reading::text;
  if (error != std::errc::result_out_of_range) return Reading::number;
  if (decimal.significant - decimal.decimals >= 0) return Reading::too_large;
  number.value = 0;
  return Reading::number;
}

Reading read_plain(std::string_view text, Number& number) {
  const bool is_negative = text.starts_with('-');
  const Decimal decimal = read_digits(text.substr(is_negative ? 1 : 0));
  number.decimals = decimal.decimals;
  number.significant = decimal.significant;
  number.rest = 0;
  constexpr int most = 19;  // digits that 64 bits can hold
  const bool is_short = decimal.significant <= most && std::abs(decimal.decimals) <= 22;
  Sum sum{0, 0};
  if (is_short) sum = scaled(decimal.digits, decimal.decimals);
  if (is_negative) sum = {-sum.high, -sum.low};
  number.value = sum.high + sum.low;
  // The sum is rounded to the nearest double: its error, at most 3 * 2^-52 of half a unit in the
  // last place, is less than the distance of a number of 21 decimals from the middle of two
  // doubles, at least 5^-21 of that.
  constexpr int most_decimals = 21;
  const bool is_read = is_short && decimal.is_plain && decimal.decimals <= most_decimals;
  const Reading reading = is_read ? Reading::number : read_by_library(text, decimal, number);
  if (is_short && std::isfinite(number.value)) {
    number.rest = (sum.high - number.value) + sum.low;
  }
  return reading;
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
