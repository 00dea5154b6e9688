#include "table/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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

/// Counts the digits of a text that is a number.
void count_digits(std::string_view text, Number& number) {
  int decimals = 0, significant = 0;
  bool behind_point = false;
  std::size_t i = text.starts_with('-') ? 1 : 0;
  for (; i < text.size() && is_digit_or_point(text[i]); ++i) {
    if (text[i] == '.') {
      behind_point = true;
      continue;
    }
    decimals += behind_point ? 1 : 0;
    significant += significant > 0 || text[i] != '0' ? 1 : 0;
  }
  number.decimals = decimals - exponent_of(text.substr(i));
  number.significant = significant;
}

/// Whether a number out of the range of doubles is too small rather than too large.
bool is_tiny(std::string_view text) {
  Number digits;
  count_digits(text, digits);
  return digits.significant - digits.decimals < 0;
}

Reading read_plain(std::string_view text, Number& number) {
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
