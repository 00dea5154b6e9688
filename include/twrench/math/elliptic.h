#pragma once

#include <twrench/math/elementary.h>

#include <array>
#include <cmath>

/// Jacobi's elliptic functions and one theta function, as the exact motion needs them
/// (docs/exact.md, which numbers its equations (E1), (E2) and so on). All functions take the
/// parameter m = k^2 and its complement mc = 1 - k^2 separately, never the modulus k: close to the
/// separatrix m rounds to 1, and mc holds all the information.
namespace twrench::elliptic {

/// Returns the complete elliptic integral of the first kind, K, for mc in [0, 1]; infinite at mc =
/// 0. The relative error is below 4 eps.
double complete_first(double mc);

/// Returns the incomplete elliptic integral of the first kind, F, of the amplitude with sine `s` in
/// [-1, 1] and cosine `c` in [0, 1], computed with Carlson's symmetric form (DLMF 19.25.5).
/// Infinite where c = mc = 0.
double incomplete_first(double s, double c, double mc);

/// Evaluates sn, cn and dn of a real argument u, and the argument of Theta(u + i a), where Theta(u)
/// = theta_4(pi u / 2K, q^2) and a = K' - a'. This argument is the elementary part of an elliptic
/// integral of the third kind; its real period is 2K, so whole periods do not add to it.
class Jacobi {
 public:
  /// Prepares the series for the parameters m and mc = 1 - m, both in [0, 1], and for `a_prime` in
  /// (0, K'].
  Jacobi(double m, double mc, double a_prime);

  /// The values at one u. The number theta = re + i im, with |theta| >= 0.4, and the angle give
  /// arg Theta(u + i a) = arg(theta) + angle.
  struct Values {
    double sn;  ///< Jacobi's sn u.
    double cn;  ///< Jacobi's cn u.
    double dn;  ///< Jacobi's dn u.
    double re;  ///< Real part of theta.
    double im;  ///< Imaginary part of theta.
    /// The remaining part of the argument, in rad, between -pi/4 and pi/4.
    double angle;
  };
  /// Evaluates all functions at u. The absolute error is a few eps, in addition to the eps |u|
  /// inherent in u.
  Values at(double u) const { return hyperbolic_ ? hyperbolic(u) : circular(u); }

  /// Whether the series are in q' = exp(-pi K/K') rather than q = exp(-pi K'/K).
  bool is_hyperbolic() const { return hyperbolic_; }
  /// What at() returns where the series are in q. It has no branch, so that a loop over it runs in
  /// vector registers.
  Values circular(double u) const;
  /// The same where the series are in q'.
  Values hyperbolic(double u) const;

  /// Returns K; infinite at mc = 0.
  double quarter_period() const { return K_; }

  /// Returns d/du arg Theta(u + i a) at u = 0.
  double slope() const { return slope_; }

 private:
  void expand_in_nome(double Kc, double a_prime);
  void expand_in_complementary_nome(double Kc, double a_prime);

  double K_;
  bool hyperbolic_;
  double slope_ = 0;
  double sn_scale_ = 0, cn_scale_ = 0, dn_scale_ = 0;

  // The series as polynomials, lowest power first; those of theta functions by even and odd powers,
  // because two of them differ in the sign of the odd ones.
  using Quadratic = std::array<double, 3>;
  using Cubic = std::array<double, 4>;

  /// In C = cos 2z, where z = pi u/2K.
  struct Circular {
    double quarter_turns;  ///< Of z per unit of u: 1/K.
    Quadratic even34, odd34;
    std::array<double, 2> even12, odd12;
    Cubic re;
    Quadratic im;  ///< Without the factor sin 2z.
  } circular_{};
  /// In x = exp(-|w|), where w = pi r/2K' and u = r + 2K turns, and y = sqrt(q') / x.
  struct Hyperbolic {
    double turns, period;    ///< 1/2K and 2K; zero where K is infinite.
    double scale;            ///< dw/du.
    double root;             ///< sqrt q'.
    double drift;            ///< d angle / du.
    double q, q2, q4, q6;    ///< Powers of q'.
    Cubic re, im;            ///< In y.
    Cubic re_rest, im_rest;  ///< In x, without a factor x.
  } hyperbolic_series_{};
};

[[gnu::always_inline]] inline Jacobi::Values Jacobi::circular(double u) const {  // Eq. (E12).
  const Circular& k = circular_;
  const auto [s, c] = elementary::sincos_quarter_turns(k.quarter_turns * u);
  const double C = (c - s) * (c + s), S = 2 * c * s, D = C * C;
  const double even12 = k.even12[0] + D * k.even12[1];
  const double odd12 = C * (k.odd12[0] + D * k.odd12[1]);
  const double even34 = k.even34[0] + D * (k.even34[1] + D * k.even34[2]);
  const double odd34 = C * (k.odd34[0] + D * k.odd34[1]);
  const double inverse = 1 / (even34 - odd34);
  return {.sn = sn_scale_ * (s * (even12 + odd12)) * inverse,
          .cn = cn_scale_ * (c * (even12 - odd12)) * inverse,
          .dn = dn_scale_ * (even34 + odd34) * inverse,
          .re = (k.re[0] + D * k.re[2]) + C * (k.re[1] + D * k.re[3]),
          .im = S * ((k.im[0] + D * k.im[2]) + C * k.im[1]),
          .angle = 0};
}

[[gnu::always_inline]] inline Jacobi::Values Jacobi::hyperbolic(double u) const {  // Eq. (E13).
  const Hyperbolic& k = hyperbolic_series_;
  const auto [turns, bits] = elementary::nearest_integer(k.turns * u);
  const double r = u - turns * k.period, side = std::copysign(1.0, r);
  const double size = std::abs(r) < K_ ? std::abs(r) : K_;
  // Hyperbolic functions of w without their growing factor e^|w|, which cancels.
  const double x = elementary::exp_minus(k.scale * size), y = k.root / x;
  const double x2 = x * x, x4 = x2 * x2, y2 = y * y, y4 = y2 * y2;
  const double x_even = 1 + k.q6 * x4, x_odd = k.q2 * x2;
  const double y_even = 1 + k.q4 * y4, y_odd = k.q * y2;
  const double even34 = 1 + k.q2 * (y4 + k.q2 * x4);
  const double odd34 = (y2 + k.q * x2) + k.q6 * (y2 * y4);
  const double theta1 = (y_even - y_odd) - x2 * (x_even - x_odd);
  const double inverse = 1 / ((y_even + y_odd) + x2 * (x_even + x_odd));
  const auto sum = [](const Cubic& a, double at) __attribute__((always_inline)) {
    return a[0] + at * (a[1] + at * (a[2] + at * a[3]));
  };
  return {.sn = elementary::negated_if_odd(side * sn_scale_ * theta1 * inverse, bits),
          .cn = elementary::negated_if_odd(cn_scale_ * x * (even34 - odd34) * inverse, bits),
          .dn = dn_scale_ * x * (even34 + odd34) * inverse,
          .re = sum(k.re, y) + x * sum(k.re_rest, x),
          .im = side * (sum(k.im, y) - x * sum(k.im_rest, x)),
          .angle = k.drift * (side * size)};
}

}  // namespace twrench::elliptic
