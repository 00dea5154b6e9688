#include "math/elliptic.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/elliptic_series.h"

namespace twrench::elliptic {

namespace {

using std::numbers::pi;

/// theta_k(0, q), eq. (E10); theta_2 omits its factor q^(1/4), which cancels wherever it is used. q
/// <= 0.124.
struct ThetaConstants {
  double theta2, theta3, theta4;
};

ThetaConstants theta_constants(double q) {
  const double q2 = q * q, q4 = q2 * q2, q6 = q2 * q4, q8 = q4 * q4, q12 = q6 * q6;
  const double even = 1 + 2 * (q4 + q8 * q8), odd = 2 * q * (1 + q8);
  return {2 * (1 + q2 + q6 + q12 + q8 * q12), even + odd, even - odd};
}

}  // namespace

/// Carlson's R_F. It is not inlined and has external linkage, so that no compiler evaluates Boost's
/// code for a constant argument: Clang 19 of Debian 13 crashes if it does so in WebAssembly's long
/// double.
[[gnu::noinline]] double carlson_rf(double x, double y, double z);
double carlson_rf(double x, double y, double z) { return boost::math::ellint_rf(x, y, z); }

double complete_first(double mc) { return incomplete_first(1, 0, mc); }

double incomplete_first(double s, double c, double mc) {
  const double delta2 = c * c + mc * s * s;
  if (delta2 == 0) return std::copysign(std::numeric_limits<double>::infinity(), s);
  return s * carlson_rf(c * c, delta2, 1.0);
}

Jacobi::Jacobi(double m, double mc, double eta_prime) : K_(complete_first(mc)) {
  const double Kc = complete_first(m);
  // The first omitted term is then below 1e-16 on either side: q <= exp(-2 pi/3) = 0.123, or q' <=
  // exp(-3 pi/2) = 0.009, whose square root governs the hyperbolic series.
  hyperbolic_ = 3 * Kc < 2 * K_;
  if (hyperbolic_) {
    expand_in_complementary_nome(Kc, eta_prime);
  } else {
    expand_in_nome(Kc, eta_prime);
  }
}

Jacobi::Values Jacobi::at(double u) const {
  return hyperbolic_ ? JacobiSeries::hyperbolic(*this, u) : JacobiSeries::circular(*this, u);
}

void Jacobi::expand_in_nome(double Kc, double eta_prime) {
  const double q = std::exp(-pi * Kc / K_);
  const auto [theta2, theta3, theta4] = theta_constants(q);
  sn_scale_ = 2 * theta3 / theta2;
  cn_scale_ = 2 * theta4 / theta2;
  dn_scale_ = theta4 / theta3;
  circular_.quarter_turns = 1 / K_;

  // The multiple angles of eq. (E10) in powers of C, eq. (E12).
  const double q2 = q * q, q3 = q * q2, q4 = q2 * q2, q6 = q3 * q3, q9 = q3 * q6, q12 = q6 * q6;
  const double e1 = 2 * q, e2 = 2 * q4, e3 = 2 * q9, e4 = 2 * q4 * q12;
  circular_.even34 = {1 - e2 + e4, 2 * e2 - 8 * e4, 8 * e4};
  circular_.odd34 = {e1 - 3 * e3, 4 * e3};
  circular_.even12 = {1 - q2 - q6 + q12, 4 * (q6 - q12)};
  circular_.odd12 = {2 * (q6 - q2) + 4 * q12, -8 * q12};

  // e^(2 alpha) = p/q and e^(-2 alpha) for alpha = pi eta/2K. Unlike alpha, p has a limit as q ->
  // 0.
  const double p = std::exp(-pi * eta_prime / K_), inverse = q > 0 ? q / p : 0;
  const double g1 = q * p, g2 = q6 * p * p, g3 = q3 * q12 * p * p * p;
  const double d1 = q2 * inverse, d2 = q4 * q4 * inverse * inverse;
  const double d3 = q6 * q12 * inverse * inverse * inverse;
  const double c1 = -(g1 + d1), c2 = g2 + d2, c3 = -(g3 + d3);
  const double s1 = g1 - d1, s2 = d2 - g2, s3 = g3 - d3;
  circular_.re = {1 - c2, c1 - 3 * c3, 2 * c2, 4 * c3};
  circular_.im = {s1 - s3, 2 * s2, 4 * s3};
  slope_ = pi / K_ * (s1 + 2 * s2 + 3 * s3) / (1 + c1 + c2 + c3);
}

void Jacobi::expand_in_complementary_nome(double Kc, double eta_prime) {
  Hyperbolic& k = hyperbolic_series_;
  k.scale = pi / (2 * Kc);
  k.turns = 0.5 / K_;
  k.period = std::isfinite(K_) ? 2 * K_ : 0;
  k.root = std::exp(-k.scale * K_);
  k.q = k.root * k.root;
  k.q2 = k.q * k.q;
  k.q4 = k.q2 * k.q2;
  k.q6 = k.q2 * k.q4;
  const auto [theta2, theta3, theta4] = theta_constants(k.q);
  sn_scale_ = theta3 / theta4;
  cn_scale_ = theta2 / theta4;
  dn_scale_ = theta2 / theta3;

  const double x = 0.5 * k.scale * (Kc - eta_prime);  // pi eta/4K'
  k.drift = -x / K_;
  double slope = 0, theta = 0;  // Slope and value of theta_2(x - i w, root) at w = 0.
  double size = 1, power = 1;   // root^(n^2) and root^n
  for (std::size_t n = 0; n < k.re.size(); ++n) {
    const auto multiple = static_cast<double>(2 * n + 1);
    k.re[n] = size * std::cos(multiple * x);
    k.im[n] = size * std::sin(multiple * x);
    k.re_rest[n] = power * k.re[n];
    k.im_rest[n] = power * k.im[n];
    theta += k.re_rest[n];
    slope += multiple * k.im_rest[n];
    size *= power * power * k.root;
    power *= k.root;
  }
  slope_ = k.drift + 0.5 * k.scale * slope / theta;
}

}  // namespace twrench::elliptic
