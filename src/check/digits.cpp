#include "check/digits.h"

#include <algorithm>
#include <cmath>

#include "check/hidden_digits.h"

namespace twrench::check {
namespace {

/// Of doubles: more digits tell nothing more.
constexpr int digits_of_double = 17;

/// How many numbers are looked at for digits that a change of their unit added.
constexpr std::size_t kept_values = 192;

bool is_float(double value) {
  return std::abs(value) <= std::numeric_limits<float>::max() &&
         static_cast<double>(static_cast<float>(value)) == value;
}

/// Whether a value that a float holds needs more than half of its bits, so that it is one by intent
/// and not by chance, as 0.5 is.
bool needs_whole_float(double value) {
  int exponent = 0;
  const double scaled = std::ldexp(std::frexp(value, &exponent), 12);
  return scaled != std::floor(scaled);
}

}  // namespace

void Digits::add(const table::Number& number) {
  all_single_ = all_single_ && is_float(number.value);
  any_long_ = any_long_ || (all_single_ && needs_whole_float(number.value));
  decimals_ = std::max(decimals_, number.decimals);
  significant_ = std::max(significant_, number.significant);
  if (number.value != 0 && first_values_.size() < kept_values)
    first_values_.push_back(number.value);
  if (number.significant == 0) return;  // zero has no leading place
  const int place = number.significant - number.decimals - 1;
  if (!last_ || place != last_place_) {
    last_ = &decades_[place];
    last_place_ = place;
  }
  ++last_->count;
  last_->decimals = std::max(last_->decimals, number.decimals);
}

/// Whether the decimals, rather than the significant digits, are the same in all decades: the rule
/// that fewer numbers break.
bool Digits::has_fixed_decimals() const {
  std::size_t fewer_decimals = 0, fewer_digits = 0;
  for (const auto& [place, decade] : decades_) {
    if (decade.decimals < decimals_) fewer_decimals += decade.count;
    if (decade.decimals + place + 1 < significant_) fewer_digits += decade.count;
  }
  return fewer_decimals <= fewer_digits;
}

bool Digits::is_single_precision() const {
  constexpr int digits_of_float = 9;
  return all_single_ && any_long_ && significant_ >= digits_of_float;
}

Resolution Digits::resolution(double unit) const {
  constexpr int long_digits = 15;
  if (significant_ >= long_digits && !is_single_precision()) {
    if (const auto hidden = find_hidden_digits(first_values_)) {
      Digits before;
      for (const table::Number& number : hidden->numbers) before.add(number);
      return before.written_resolution(unit * hidden->factor);
    }
  }
  return written_resolution(unit);
}

Resolution Digits::written_resolution(double unit) const {
  Resolution resolution;
  resolution.unit = unit;
  if (is_single_precision()) {
    resolution.relative = std::numeric_limits<float>::epsilon();
  } else if (significant_ < digits_of_double && !has_fixed_decimals()) {
    resolution.relative = std::pow(10.0, 1 - significant_);
    resolution.base = 10;
  } else if (significant_ < digits_of_double && decimals_ > std::numeric_limits<int>::min()) {
    resolution.absolute = unit * std::pow(10.0, -decimals_);
  }
  return resolution;
}

void TimeDigits::add(const table::Number& number) {
  digits_.add(number);
  ++count_;
  if (count_ == 1) first_ = number.value;
  if (count_ == 2) step_ = number.value - first_;
  // Decimals are rounded to doubles, of which the step is a difference.
  const double expected = first_ + step_ * static_cast<double>(count_ - 1);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                          std::max(std::abs(number.value), std::abs(first_));
  const double allowed = rounding * static_cast<double>(count_);
  if (count_ > 2 && std::abs(number.value - expected) > allowed) equally_spaced_ = false;
}

Resolution TimeDigits::resolution(double unit) const {
  if (count_ < 3 || !equally_spaced_) return digits_.resolution(unit);
  Resolution exact;
  exact.unit = unit;
  return exact;
}

}  // namespace twrench::check
