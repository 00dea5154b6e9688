#include "math/elliptic.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace twrench::elliptic {

namespace {

using std::numbers::pi;

/// The n-th power of x >= 0, and 1 for n = 0.
double power(double x, std::size_t n) { return std::pow(x, static_cast<double>(n)); }

/// theta_k(0, q), eq. (E10); for theta_2 without its factor q^(1/4), which cancels wherever it is
/// used. q <= 0.124.
struct ThetaConstants {
  double theta2, theta3, theta4;
};

ThetaConstants theta_constants(double q) {
  ThetaConstants t{2, 1, 1};
  for (std::size_t n = 1; n < 5; ++n) {
    const double term = 2 * power(q, n * n);
    t.theta2 += 2 * power(q, n * (n + 1));
    t.theta3 += term;
    t.theta4 += n % 2 == 0 ? term : -term;
  }
  return t;
}

}  // namespace

double complete_first(double mc) { return incomplete_first(1, 0, mc); }

double incomplete_first(double s, double c, double mc) {
  const double delta2 = c * c + mc * s * s;
  if (delta2 == 0) return std::copysign(std::numeric_limits<double>::infinity(), s);
  return s * boost::math::ellint_rf(c * c, delta2, 1.0);
}

Jacobi::Jacobi(double m, double mc, double a_prime) : K_(complete_first(mc)) {
  const double Kc = complete_first(m);
  // The first omitted term is then below 1e-16 on either side: q <= exp(-2 pi/3) = 0.123, or q' <=
  // exp(-3 pi/2) = 0.009, whose square root governs the hyperbolic series.
  hyperbolic_ = 3 * Kc < 2 * K_;
  if (hyperbolic_) {
    expand_in_complementary_nome(Kc, a_prime);
  } else {
    expand_in_nome(Kc, a_prime);
  }
}

void Jacobi::expand_in_nome(double Kc, double a_prime) {
  scale_ = pi / (2 * K_);
  const double q = std::exp(-pi * Kc / K_);
  const auto [theta2, theta3, theta4] = theta_constants(q);
  sn_scale_ = 2 * theta3 / theta2;
  cn_scale_ = 2 * theta4 / theta2;
  dn_scale_ = theta4 / theta3;

  // e^(2 alpha) = p/q and e^(-2 alpha) for alpha = pi a/2K. Unlike alpha, p has a limit as q -> 0.
  const double p = std::exp(-pi * a_prime / K_), inverse = q > 0 ? q / p : 0;
  even_[0] = odd_[0] = cosine_[0] = 1;
  double slope = 0, theta = 1;  // Of Theta(u + i a) at u = 0.
  for (std::size_t n = 1; n < terms; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1;
    const double growing = power(q, n * (2 * n - 1)) * power(p, n);
    const double decaying = power(q, 2 * n * n) * power(inverse, n);
    even_[n] = 2 * power(q, n * n);
    odd_[n] = power(q, n * (n + 1));
    cosine_[n] = sign * (growing + decaying);
    sine_[n] = -sign * (growing - decaying);
    theta += cosine_[n];
    slope += 2 * static_cast<double>(n) * sine_[n];
  }
  slope_ = scale_ * slope / theta;
}

void Jacobi::expand_in_complementary_nome(double Kc, double a_prime) {
  scale_ = pi / (2 * Kc);
  turns_per_unit_ = 0.5 / K_;
  root_ = std::exp(-scale_ * K_);
  const double q = root_ * root_;  // q'
  const auto [theta2, theta3, theta4] = theta_constants(q);
  sn_scale_ = theta3 / theta4;
  cn_scale_ = theta2 / theta4;
  dn_scale_ = theta2 / theta3;

  const double x = 0.5 * scale_ * (Kc - a_prime);  // pi a/4K'
  drift_ = -x / K_;
  double slope = 0, theta = 0;  // Of theta_2(x - i w, root) at w = 0.
  for (std::size_t n = 0; n < terms; ++n) {
    const auto multiple = static_cast<double>(2 * n + 1);
    even_[n] = power(q, n * n - n);
    odd_[n] = power(q, n * n);
    cosine_[n] = power(root_, n * n) * std::cos(multiple * x);
    sine_[n] = power(root_, n * n) * std::sin(multiple * x);
    theta += power(root_, n) * cosine_[n];
    slope += power(root_, n) * multiple * sine_[n];
  }
  slope_ = drift_ + 0.5 * scale_ * slope / theta;
}

Jacobi::Values Jacobi::circular(double u) const {  // Eq. (E10).
  const double z = scale_ * u;
  const double c = std::cos(z), s = std::sin(z);
  const double c2 = (c - s) * (c + s), s2 = 2 * c * s;
  double theta1 = s, theta2 = c, theta3 = 1, theta4 = 1, re = 1, im = 0;
  double cn = 1, sn = 0, sign = 1;  // cos 2nz, sin 2nz, (-1)^n
  for (std::size_t n = 1; n < terms; ++n) {
    const double previous = cn;
    cn = cn * c2 - sn * s2;
    sn = sn * c2 + previous * s2;
    sign = -sign;
    theta1 += sign * odd_[n] * (sn * c + cn * s);
    theta2 += odd_[n] * (cn * c - sn * s);
    theta3 += even_[n] * cn;
    theta4 += sign * even_[n] * cn;
    re += cosine_[n] * cn;
    im += sine_[n] * sn;
  }
  const double inverse = 1 / theta4;
  return {sn_scale_ * theta1 * inverse,
          cn_scale_ * theta2 * inverse,
          dn_scale_ * theta3 * inverse,
          {re, im},
          0};
}

Jacobi::Values Jacobi::hyperbolic(double u) const {  // Eq. (E11).
  // u = 2K turns + r, where turns = 0 if K is infinite.
  const double turns = std::nearbyint(turns_per_unit_ * u);
  const double r = turns == 0 ? u : u - turns * (2 * K_);
  // Hyperbolic functions of w = scale r without their growing factor e^|w|, which cancels.
  const double x = std::exp(-scale_ * std::abs(r));
  const double y = x > 0 ? root_ / x : 0;  // exp(-scale (K - |r|))
  const double x2 = x * x, x4 = x2 * x2, y2 = y * y;
  double theta1 = 1 - x2, theta2 = 1 + x2, theta3 = 1, theta4 = 1;
  double re = cosine_[0] * (1 + x), im = sine_[0] * (1 - x);
  double xn = x, xe = 1, xo = x2, yn = 1, y2n = 1, sign = 1;  // x^(2n+1), x^4n, x^(4n+2), ...
  for (std::size_t n = 1; n + 1 < terms; ++n) {
    xn *= x2;
    xe *= x4;
    xo *= x4;
    yn *= y;
    y2n *= y2;
    sign = -sign;
    theta1 += sign * odd_[n] * y2n * (1 - xo);
    theta2 += odd_[n] * y2n * (1 + xo);
    theta3 += even_[n] * y2n * (1 + xe);
    theta4 += sign * even_[n] * y2n * (1 + xe);
    re += cosine_[n] * yn * (1 + xn);
    im += sine_[n] * yn * (1 - xn);
  }
  const double half_turn = 2 * std::nearbyint(0.5 * turns) == turns ? 1 : -1,
               side = std::copysign(1.0, r);
  const double inverse = 1 / theta2;
  return {half_turn * side * sn_scale_ * theta1 * inverse,
          half_turn * cn_scale_ * x * theta4 * inverse,
          dn_scale_ * x * theta3 * inverse,
          {re, side * im},
          drift_ * r};
}

}  // namespace twrench::elliptic
