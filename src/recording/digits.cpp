#include "recording/digits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "recording/hidden_digits.h"

namespace twrench::recording {
namespace {

/// Further digits of a double carry no information.
constexpr int digits_of_double = 17;

/// Numbers with so many digits may have some that mean nothing.
constexpr int long_digits = 15;

/// How many numbers are examined for digits that a conversion of their unit added.
constexpr std::size_t kept_values = 192;

/// At this level, one file in a million passes for one of a narrow format by chance.
constexpr double enough_evidence = 20;  // bits

/// One unit of a decimal place: 10^-decimals.
double unit_of_place(int decimals) {
  static const std::array<double, 23> powers = [] {
    std::array<double, 23> list{};
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = std::pow(10.0, -static_cast<double>(i));
    return list;
  }();
  const auto place = static_cast<std::size_t>(decimals);
  return decimals >= 0 && place < powers.size() ? powers[place] : std::pow(10.0, -decimals);
}

/// Whether the value and the rest are together the number that was written or stored.
bool is_written_exactly(const table::Number& number) {
  constexpr int most_digits = 19;  // of an integer, as Number::rest allows
  const bool is_integer = number.decimals <= 0 && (number.significant <= most_digits ||
                                                   number.significant == number.all_digits);
  return is_integer || number.significant < digits_of_double;
}

/// Whether the number has at most two digits before its zeros: 10, 250, 0.5.
bool is_round(const table::Number& number) {
  constexpr int most = 2;
  if (number.value == 0 || number.significant <= most) return true;
  if (number.significant > digits_of_double) return false;
  const double scale = std::pow(10.0, std::floor(std::log10(std::abs(number.value))) - (most - 1));
  const double digits = number.value / scale;
  return std::abs(digits - std::nearbyint(digits)) < 1e-9;
}

/// The decimals of a number without the zeros at the end of a whole one: negative then. A clock
/// that is coarser than the unit leaves such zeros, and so do decimals that fill up to the point.
int decimals_without_zeros(double value, int decimals) {
  if (decimals > 0 || value == 0) return decimals;
  int count = 0;
  for (double rest = value; std::fmod(rest, 10) == 0; rest /= 10) --count;
  return count;
}

}  // namespace

double Resolution::at(double value) const {
  const double size = std::abs(offset + value);
  const double doubles = std::numeric_limits<double>::epsilon() * size;
  const double in_file = size / unit;
  if (in_file == 0 || !std::isfinite(in_file)) return std::max(absolute, doubles);
  const double leading = base == 2 ? std::exp2(std::floor(std::log2(in_file)))
                                   : std::pow(10.0, std::floor(std::log10(in_file)));
  return std::max({absolute, unit * relative * leading, doubles});
}

void NarrowFormat::add(const table::Number& number) {
  if (!all_ || number.value == 0) return;
  int exponent = 0;
  std::frexp(number.value, &exponent);
  const int last_bit = std::max(exponent, least_exponent_) - bits_;
  const double spacing = std::ldexp(1.0, last_bit);
  const double nearest = spacing * std::nearbyint(number.value / spacing);
  const double place = unit_of_place(decimals_without_zeros(number.value, number.decimals));
  // The printed number differs from the value by at most half a unit of its last place.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const double allowed = place / 2 + rounding * std::abs(number.value);
  const double apart = std::abs(number.value - nearest);
  all_ = apart <= allowed;
  farthest_ = std::max(farthest_, apart / spacing);
  if (!all_ || evidence_ > enough_evidence) return;
  // A number of few bits, such as 0.5, is a value of any format, and so is a whole number that
  // needs no more bits than the format has.
  const double few_bits = std::ldexp(spacing, bits_ / 2);
  const double round_unit = spacing <= 1 ? std::min(few_bits, 1.0) : few_bits;
  const bool is_round = std::fmod(nearest, round_unit) == 0;
  if (!is_round) evidence_ += std::max(0.0, std::log2(spacing / (2 * allowed)));
}

bool NarrowFormat::holds_all() const { return all_ && evidence_ > enough_evidence; }

void Digits::add(const table::Number& number) {
  are_round_ = are_round_ && is_round(number);
  float16_.add(number);
  float32_.add(number);
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

/// Whether the number of decimals, rather than that of significant digits, is the same in all
/// decades. Decides for the rule that fewer numbers break.
bool Digits::has_fixed_decimals() const {
  std::size_t fewer_decimals = 0, fewer_digits = 0;
  for (const auto& [place, decade] : decades_) {
    if (decade.decimals < decimals_) fewer_decimals += decade.count;
    if (decade.decimals + place + 1 < significant_) fewer_digits += decade.count;
  }
  return fewer_decimals <= fewer_digits;
}

Resolution Digits::resolution(double unit) const {
  if (significant_ >= long_digits && !float32_.holds_all()) {
    if (const auto hidden = find_hidden_digits(first_values_, may_be_angles_)) {
      Digits before(may_be_angles_);
      for (const table::Number& number : hidden->numbers) before.add(number);
      Resolution resolution = before.written_resolution(unit * hidden->factor);
      resolution.converted = hidden->factor != 1;
      return resolution;
    }
  }
  return written_resolution(unit);
}

Resolution Digits::written_resolution(double unit) const {
  Resolution resolution;
  resolution.unit = unit;
  const bool is_narrow = float16_.holds_all() || float32_.holds_all();
  const bool is_short = significant_ < digits_of_double;
  if (is_narrow) {
    const bool is_half = float16_.holds_all();
    resolution.written = is_half ? NumberFormat::float16 : NumberFormat::float32;
    resolution.relative = (is_half ? float16_ : float32_).resolution();
  } else if (is_short && !has_fixed_decimals()) {
    resolution.written = NumberFormat::digits;
    resolution.count = significant_;
    resolution.relative = std::pow(10.0, 1 - significant_);
    resolution.base = 10;
  } else if (is_short && decimals_ > std::numeric_limits<int>::min()) {
    resolution.written = NumberFormat::decimals;
    resolution.count = decimals_;
  }
  // A narrow format may be printed with fewer decimals than it needs.
  const bool has_last_place =
      resolution.written == NumberFormat::decimals || (is_narrow && is_short);
  if (has_last_place) resolution.absolute = unit * unit_of_place(decimals_);
  return resolution;
}

void TimeDigits::add(const table::Number& number) {
  ++count_;
  if (count_ == 1) first_ = number;
  const double since = (number.value - first_.value) + (number.rest - first_.rest);
  if (count_ == 2) step_ = since;
  const bool is_exact = are_known_exact_ || is_written_exactly(number);
  are_exact_ = are_exact_ && is_exact;
  are_round_ = are_round_ && is_round(number);
  if (is_exact && since != 0) {
    decimals_ = std::max(decimals_, decimals_without_zeros(since, number.decimals));
  }
  are_long_ = are_long_ || (is_exact && number.significant >= long_digits);
  digits_.add(number);
  // The step is a difference of two rounded times.
  const double expected = step_ * static_cast<double>(count_ - 1);
  const double size =
      are_exact_ ? std::abs(since) : std::max(std::abs(number.value), std::abs(first_.value));
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const double allowed = rounding * size * static_cast<double>(count_);
  if (count_ > 2 && std::abs(since - expected) > allowed) equally_spaced_ = false;
}

Resolution TimeDigits::resolution(double unit) const {
  constexpr std::size_t few = 8;
  const bool is_exact = (count_ > 2 && equally_spaced_) || (count_ <= few && are_round_);
  Resolution resolution;
  resolution.unit = unit;
  const bool has_difference = decimals_ > std::numeric_limits<int>::min();
  if (!is_exact && are_exact_ && are_long_ && has_difference) {
    resolution.written = NumberFormat::decimals;
    resolution.count = std::max(decimals_, 0);
    resolution.absolute = unit * unit_of_place(decimals_);
  } else if (!is_exact) {
    resolution = digits_.resolution(unit);
  }
  // Otherwise the spacing is that of the differences.
  const bool is_of_clock = is_exact ? !are_exact_ : resolution.written != NumberFormat::decimals;
  if (is_of_clock) resolution.offset = unit * first_.value;
  return resolution;
}

}  // namespace twrench::recording
