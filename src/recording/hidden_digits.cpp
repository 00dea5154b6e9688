#include "recording/hidden_digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "table/number_text.h"

namespace twrench::recording {
namespace {

/// By chance, one double in fifty is this close to a number of 13 digits, but never many of them.
constexpr int most_digits = 13;
constexpr double rounding = 1e-15;

double read_double(const std::string& text) {
  table::Number number;
  table::read_number(text, false, number);
  return number.value;
}

/// The constant as programs write it: in full, and rounded or truncated to 3 ... 16 digits.
std::vector<double> abridged(double constant) {
  std::vector<double> values{constant};
  const std::string digits = fmt::format("{:.16e}", constant);  // "5.72...e+01"
  const std::string exponent = digits.substr(digits.find('e'));
  for (int count = 2; count <= 15; ++count) {
    values.push_back(read_double(fmt::format("{:.{}e}", constant, count)));
    values.push_back(read_double(digits.substr(0, static_cast<std::size_t>(count) + 2) + exponent));
  }
  return values;
}

/// The factors by which programs convert radians to degrees and back, and 1 for no conversion.
std::vector<double> conversion_factors() {
  std::vector<double> factors{1};
  for (const double factor : abridged(180 / std::numbers::pi)) {
    factors.insert(factors.end(), {factor, 1 / factor});
  }
  for (const double factor : abridged(std::numbers::pi / 180)) {
    factors.insert(factors.end(), {factor, 1 / factor});
  }
  for (const double pi : abridged(std::numbers::pi)) {
    factors.insert(factors.end(), {180 / pi, pi / 180});
  }
  return factors;
}

/// Returns the value as a number of at most 13 digits, if it is one up to rounding.
std::optional<table::Number> as_short_number(double value) {
  const std::string text = fmt::format("{:.{}e}", value, most_digits - 1);
  table::Number number;
  table::read_number(text, false, number);
  if (std::abs(number.value - value) > rounding * std::abs(value)) return std::nullopt;
  const std::size_t end = text.find('e');
  const std::size_t last = text.find_last_not_of('0', end - 1);
  const int zeros = std::min(static_cast<int>(end - 1 - last), most_digits - 1);
  number.decimals -= zeros;
  number.significant -= zeros;
  return number;
}

std::optional<HiddenDigits> undo(double factor, std::span<const double> values) {
  HiddenDigits hidden{factor, {}};
  for (const double value : values) {
    const auto number = as_short_number(value / factor);
    if (!number) return std::nullopt;
    hidden.numbers.push_back(*number);
  }
  return hidden;
}

}  // namespace

std::optional<HiddenDigits> find_hidden_digits(std::span<const double> values, bool may_be_angles) {
  constexpr std::size_t enough = 16;
  if (std::set<double>(values.begin(), values.end()).size() < enough) return std::nullopt;
  if (!may_be_angles) return undo(1, values);
  for (const double factor : conversion_factors()) {
    if (auto hidden = undo(factor, values)) return hidden;
  }
  return std::nullopt;
}

}  // namespace twrench::recording
