#pragma once

#include <cmath>

#include "math/elementary.h"
#include "math/elliptic.h"

namespace twrench::elliptic {

/// The series of Jacobi. They are inline so that a loop over them runs in vector registers, and
/// private so that only the library's compiler flags apply to them. None has a branch.
struct JacobiSeries {
  /// Returns whether the series are in q' = exp(-pi K/K') rather than q = exp(-pi K'/K).
  static bool is_hyperbolic(const Jacobi& j) { return j.hyperbolic_; }

  /// Evaluates the series in q, eq. (E12).
  [[gnu::always_inline]] static Jacobi::Values circular(const Jacobi& j, double u) {
    const Jacobi::Circular& k = j.circular_;
    const auto [s, c] = elementary::sincos_quarter_turns(k.quarter_turns * u);
    const double C = (c - s) * (c + s), S = 2 * c * s, D = C * C;
    const double even12 = k.even12[0] + D * k.even12[1];
    const double odd12 = C * (k.odd12[0] + D * k.odd12[1]);
    const double even34 = k.even34[0] + D * (k.even34[1] + D * k.even34[2]);
    const double odd34 = C * (k.odd34[0] + D * k.odd34[1]);
    const double inverse = 1 / (even34 - odd34);
    return {.sn = j.sn_scale_ * (s * (even12 + odd12)) * inverse,
            .cn = j.cn_scale_ * (c * (even12 - odd12)) * inverse,
            .dn = j.dn_scale_ * (even34 + odd34) * inverse,
            .re = (k.re[0] + D * k.re[2]) + C * (k.re[1] + D * k.re[3]),
            .im = S * ((k.im[0] + D * k.im[2]) + C * k.im[1]),
            .angle = 0};
  }

  /// Evaluates the series in q', eq. (E13).
  [[gnu::always_inline]] static Jacobi::Values hyperbolic(const Jacobi& j, double u) {
    const Jacobi::Hyperbolic& k = j.hyperbolic_series_;
    const auto [turns, bits] = elementary::nearest_integer(k.turns * u);
    const double r = u - turns * k.period, side = std::copysign(1.0, r);
    const double size = std::abs(r) < j.K_ ? std::abs(r) : j.K_;
    // Hyperbolic functions of w without their growing factor e^|w|, because it cancels.
    const double x = elementary::exp_minus(k.scale * size), y = k.root / x;
    const double x2 = x * x, x4 = x2 * x2, y2 = y * y, y4 = y2 * y2;
    const double x_even = 1 + k.q6 * x4, x_odd = k.q2 * x2;
    const double y_even = 1 + k.q4 * y4, y_odd = k.q * y2;
    const double even34 = 1 + k.q2 * (y4 + k.q2 * x4);
    const double odd34 = (y2 + k.q * x2) + k.q6 * (y2 * y4);
    const double theta1 = (y_even - y_odd) - x2 * (x_even - x_odd);
    const double inverse = 1 / ((y_even + y_odd) + x2 * (x_even + x_odd));
    const auto sum = [](const Jacobi::Cubic& a, double at) __attribute__((always_inline)) {
      return a[0] + at * (a[1] + at * (a[2] + at * a[3]));
    };
    return {.sn = elementary::negated_if_odd(side * j.sn_scale_ * theta1 * inverse, bits),
            .cn = elementary::negated_if_odd(j.cn_scale_ * x * (even34 - odd34) * inverse, bits),
            .dn = j.dn_scale_ * x * (even34 + odd34) * inverse,
            .re = sum(k.re, y) + x * sum(k.re_rest, x),
            .im = side * (sum(k.im, y) - x * sum(k.im_rest, x)),
            .angle = k.drift * (side * size)};
  }
};

}  // namespace twrench::elliptic
