#pragma once

#include <cmath>

namespace twrench::body {

/// A number of about 106 significant bits: the unevaluated sum of two doubles. Its relative errors
/// are a few times 2^-106. Sources: Dekker, Numer. Math. 18 (1971) 224; Joldes, Muller and Popescu,
/// ACM Trans. Math. Softw. 44 (2017) 15, algorithms 6 and 12.
struct DoubleDouble {
  double high = 0.0;  ///< The number rounded to double.
  double low = 0.0;   ///< The remainder.

  explicit operator double() const { return high; }
};

/// Returns a + b exactly; |a| must not be less than |b|.
inline DoubleDouble sum_of_ordered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Returns a + b exactly.
inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// Returns a b exactly, unless it overflows or its last bits underflow. Does not use a fused
/// operation, which some processors lack.
inline DoubleDouble exact_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double a_scaled = splitter * a, b_scaled = splitter * b;
  const double a_high = a_scaled - (a_scaled - a), b_high = b_scaled - (b_scaled - b);
  const double a_low = a - a_high, b_low = b - b_high;
  const double product = a * b;
  const double rest =
      ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
  return {product, rest};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  const DoubleDouble partial = sum_of_ordered(high.high, high.low + low.high);
  return sum_of_ordered(partial.high, partial.low + low.low);
}

inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_product(a.high, b.high);
  return sum_of_ordered(high.high, high.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator*(const DoubleDouble& a, double b) {
  const DoubleDouble high = exact_product(a.high, b);
  return sum_of_ordered(high.high, high.low + a.low * b);
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  return sum_of_ordered(first, rest.high / b.high);
}

}  // namespace twrench::body
