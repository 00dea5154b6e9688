#include "math/elliptic.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace twrench::elliptic {

namespace {

using std::numbers::pi;

/// The theta constants of a nome q <= 0.13 to double precision, DLMF 20.2.2-4 at z = 0;
/// theta_2 without its factor q^(1/4), which cancels wherever it is used.
struct ThetaConstants {
  double theta2, theta3, theta4;
};

ThetaConstants theta_constants(double q) {
  const double q2 = q * q, q4 = q2 * q2, q6 = q4 * q2, q9 = q6 * q2 * q, q12 = q6 * q6;
  const double even = 2 * q4 * (1 + q12), odd = 2 * q * (1 + q4 * q4);
  static_cast<void>(q9);
  return {2 * (1 + q2 + q6 + q12), 1 + odd + even, 1 - odd + even};
}

}  // namespace

double complete_first(double mc) { return incomplete_first(1, 0, mc); }

double incomplete_first(double s, double c, double mc) {
  const double delta2 = c * c + mc * s * s;
  if (delta2 == 0) {
    return std::copysign(std::numeric_limits<double>::infinity(), s);
  }
  return s * boost::math::ellint_rf(c * c, delta2, 1.0);
}

Jacobi::Jacobi(double m, double mc, double a_prime) : K_(complete_first(mc)) {
  const double Kc = complete_first(m);
  // Each expansion is used where five terms of it are exact to double precision: q <= 0.124 on this
  // side, q' <= 0.009 on that one, where the square root of q' sets the pace.
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

  const double p = std::exp(-pi * a_prime / K_);  // q e^(2 alpha), alpha = pi a / 2K
  const double inverse = q > 0 ? q / p : 0;       // e^(-2 alpha)
  double slope = 0, theta0 = 0;
  for (int n = 0; n < terms; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1;
    const double half = n == 0 ? 0.5 : 1;
    even_[n] = half * 2 * std::pow(q, n * n);
    odd_[n] = std::pow(q, n * (n + 1));
    const double growing = std::pow(q, n * (2 * n - 1)) * std::pow(p, n);
    const double decaying = std::pow(q, 2 * n * n) * std::pow(inverse, n);
    real_[n] = half * sign * (growing + decaying);
    imaginary_[n] = -sign * (growing - decaying);
    theta0 += real_[n];
    slope += 2 * n * imaginary_[n];
  }
  slope_ = scale_ * slope / theta0;
}

void Jacobi::expand_in_complementary_nome(double Kc, double a_prime) {
  scale_ = pi / (2 * Kc);
  const double q = std::exp(-pi * K_ / Kc);
  const double root = std::exp(-scale_ * K_);
  const auto [theta2, theta3, theta4] = theta_constants(q);
  sn_scale_ = theta3 / theta4;
  cn_scale_ = theta2 / theta4;
  dn_scale_ = theta2 / theta3;

  const double x = 0.5 * scale_ * (Kc - a_prime);  // pi a / 4K'
  shift_ = -x / K_;
  double slope = 0, theta0 = 0;
  for (int n = 0; n < terms; ++n) {
    even_[n] = std::pow(q, n * (n - 1));
    odd_[n] = std::pow(q, n * n);
    const double size = std::pow(root, n * n);
    real_[n] = size * std::cos((2 * n + 1) * x);
    imaginary_[n] = size * std::sin((2 * n + 1) * x);
    theta0 += std::pow(root, n) * real_[n];
    slope += std::pow(root, n) * (2 * n + 1) * imaginary_[n];
  }
  slope_ = shift_ + 0.5 * scale_ * slope / theta0;
}

Jacobi::Values Jacobi::circular(double u) const {
  const double z = scale_ * u;
  const double c = std::cos(z), s = std::sin(z);
  const double c2 = (c - s) * (c + s), s2 = 2 * c * s;
  double theta1 = s, theta2 = c, theta3 = 1, theta4 = 1, re = real_[0], im = 0;
  double cn = 1, sn = 0, sign = 1;  // of 2 n z
  for (int n = 1; n < terms; ++n) {
    const double next = cn * c2 - sn * s2;
    sn = sn * c2 + cn * s2;
    cn = next;
    sign = -sign;
    theta1 += sign * odd_[n] * (sn * c + cn * s);
    theta2 += odd_[n] * (cn * c - sn * s);
    theta3 += even_[n] * cn;
    theta4 += sign * even_[n] * cn;
    re += real_[n] * cn;
    im += imaginary_[n] * sn;
  }
  return {sn_scale_ * theta1 / theta4, cn_scale_ * theta2 / theta4, dn_scale_ * theta3 / theta4,
          {re, im}, 0};
}

Jacobi::Values Jacobi::hyperbolic(double u) const {
  const double period = std::nearbyint(0.5 * u / K_);
  const double r = period == 0 ? u : std::fma(-2 * period, K_, u);
  const double x = std::exp(-scale_ * std::abs(r));
  const double Y = std::exp(-scale_ * (K_ - std::abs(r)));
  const double x2 = x * x, y = Y * Y;
  // theta_k(i w, q') e^-w, with the growing half of each hyperbolic function taken out.
  double theta1 = 1 - x2, theta2 = 1 + x2, theta3 = 1, theta4 = 1;
  double re = real_[0] * (1 + x), im = imaginary_[0] * (1 - x);
  double even = 1, odd = x2, single = x, yn = 1, Yn = 1, sign = 1;
  for (int n = 1; n < terms; ++n) {
    even *= x2 * x2;
    odd *= x2 * x2;
    single *= x2;
    yn *= y;
    Yn *= Y;
    sign = -sign;
    theta1 += sign * odd_[n] * yn * (1 - odd);
    theta2 += odd_[n] * yn * (1 + odd);
    theta3 += even_[n] * yn * (1 + even);
    theta4 += sign * even_[n] * yn * (1 + even);
    re += real_[n] * Yn * (1 + single);
    im += imaginary_[n] * Yn * (1 - single);
  }
  const double turned = std::fmod(period, 2.0) == 0 ? 1 : -1;
  const double side = std::copysign(1.0, r);
  return {turned * side * sn_scale_ * theta1 / theta2, turned * cn_scale_ * x * theta4 / theta2,
          dn_scale_ * x * theta3 / theta2, {re, side * im}, shift_ * r};
}

}  // namespace twrench::elliptic
