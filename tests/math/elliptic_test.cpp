#include "math/elliptic.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace twrench::elliptic {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
constexpr double eps = std::numeric_limits<double>::epsilon();

Real pi() { return boost::math::constants::pi<Real>(); }

Real complete(const Real& mc) {
  Real a = 1, b = sqrt(mc);
  while (abs(a - b) > 1e-40 * a) {
    const Real mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return pi() / (a + b);
}

struct Reference {
  Real sn, cn, dn, theta;  ///< theta is arg Theta(u + i a) from its series in q, at any u
};

/// Sums the definitions, DLMF 22.2.4-6 and 20.2.4, in 50 digits, without transformation or
/// reduction and with as many terms as necessary.
Reference by_definition(const Real& u, const Real& m, const Real& mc, const Real& a_prime) {
  const Real K = complete(mc), Kc = complete(m), q = exp(-pi() * Kc / K), z = pi() * u / (2 * K);
  const Real alpha = pi() * (Kc - a_prime) / (2 * K);
  struct Thetas {
    Real t1 = 0, t2 = 0, t3 = 1, t4 = 1;
  };
  const auto thetas = [&](const Real& at) {
    Thetas t;
    for (int n = 0; n < 60; ++n) {
      const int sign = n % 2 == 0 ? 1 : -1;
      const Real odd = 2 * pow(q, n * (n + 1)), even = 2 * pow(q, n * n);
      t.t1 += sign * odd * sin((2 * n + 1) * at);
      t.t2 += odd * cos((2 * n + 1) * at);
      if (n == 0) continue;
      t.t3 += even * cos(2 * n * at);
      t.t4 += sign * even * cos(2 * n * at);
    }
    return t;
  };
  const Thetas t = thetas(z), zero = thetas(0);
  Real re = 1, im = 0;
  for (int n = 1; n < 60; ++n) {
    const Real size = (n % 2 == 0 ? 2 : -2) * pow(q, 2 * n * n);
    re += size * cosh(2 * n * alpha) * cos(2 * n * z);
    im -= size * sinh(2 * n * alpha) * sin(2 * n * z);
  }
  return {zero.t3 / zero.t2 * t.t1 / t.t4, zero.t4 / zero.t2 * t.t2 / t.t4,
          zero.t4 / zero.t3 * t.t3 / t.t4, atan2(im, re)};
}

struct Complement {
  double m, mc;
};

/// Returns parameters on both sides of the change of series at m = 0.955.
std::vector<Complement> complements() {
  return {{1e-12, 1 - 1e-12}, {0.1, 0.9},   {0.5, 0.5},       {0.75, 0.25},       {0.95, 0.05},
          {0.96, 0.04},       {0.99, 0.01}, {1 - 1e-5, 1e-5}, {1 - 1e-11, 1e-11}, {1, 1e-18}};
}

double argument(const Jacobi::Values& v) { return std::atan2(v.im, v.re) + v.angle; }

TEST(CompleteFirst, KnownValues) {
  EXPECT_DOUBLE_EQ(complete_first(1), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(complete_first(0.5), 1.8540746773013719184);
  EXPECT_DOUBLE_EQ(complete_first(1e-300), std::log(4) + 150 * std::log(10));
  EXPECT_EQ(complete_first(0), std::numeric_limits<double>::infinity());
}

TEST(CompleteFirst, EqualsTheArithmeticGeometricMean) {
  for (const auto [m, mc] : complements()) {
    EXPECT_NEAR(static_cast<double>(complete_first(mc) / complete(mc)), 1, 4 * eps) << mc;
  }
}

TEST(IncompleteFirst, LimitsOfTheParameter) {
  for (const double phi : {0.0, 1e-9, 0.3, 1.0, 1.5}) {
    const double s = std::sin(phi), c = std::cos(phi);
    EXPECT_NEAR(incomplete_first(s, c, 1), phi, 4 * eps * phi);
    EXPECT_NEAR(incomplete_first(-s, c, 0), -std::asinh(s / c), 4 * eps * std::asinh(s / c));
  }
  EXPECT_EQ(incomplete_first(1, 0, 0.3), complete_first(0.3));
  EXPECT_EQ(incomplete_first(-1, 0, 0), -std::numeric_limits<double>::infinity());
}

TEST(IncompleteFirst, IsTheInverseOfSn) {
  for (const auto [m, mc] : complements()) {
    const Jacobi jacobi(m, mc, 0.5);
    for (const double share : {-0.9, 0.1, 0.5, 0.7}) {
      const double u = share * std::min(jacobi.quarter_period(), 5.0);
      const auto v = jacobi.at(u);
      EXPECT_NEAR(incomplete_first(v.sn, v.cn, mc), u, 40 * eps * (1 + 1 / v.dn)) << mc;
    }
  }
}

TEST(Jacobi, EqualsItsDefinition) {
  for (const auto [m, mc] : complements()) {
    const double Kc = complete_first(m);
    for (const double share : {0.05, 0.5, 0.999}) {
      const double a_prime = share * Kc;
      const Jacobi jacobi(m, mc, a_prime);
      const double K = jacobi.quarter_period();
      for (const double u : {0.0, 1e-7, 0.3 * K, K, -0.98 * K, 1.3 * K, -1.9 * K, 2 * K, 7.7 * K}) {
        SCOPED_TRACE(testing::Message() << "mc " << mc << " a'/K' " << share << " u/K " << u / K);
        // The function receives both m and mc, so the rounding of 1 - m is not its error.
        const Reference r = by_definition(u, mc < 0.5 ? Real(1) - mc : Real(m),
                                          mc < 0.5 ? Real(mc) : Real(1) - m, a_prime);
        const auto v = jacobi.at(u);
        const double bound = 8 * eps * (1 + std::abs(u));
        EXPECT_NEAR(v.sn, static_cast<double>(r.sn), bound);
        EXPECT_NEAR(v.cn, static_cast<double>(r.cn), bound);
        EXPECT_NEAR(v.dn, static_cast<double>(r.dn), bound);
        EXPECT_NEAR(argument(v), static_cast<double>(r.theta), bound);
        EXPECT_GT(std::hypot(v.re, v.im), 0.4);
      }
    }
  }
}

TEST(Jacobi, SlopeIsTheDerivativeAtZero) {
  const Real h = 1e-12;
  for (const auto [m, mc] : complements()) {
    for (const double a_prime : {0.1, 1.0}) {
      const Real exact_m = mc < 0.5 ? Real(1) - mc : Real(m), exact_mc = Real(1) - exact_m;
      const Real slope = by_definition(h, exact_m, exact_mc, a_prime).theta / h;
      EXPECT_NEAR(Jacobi(m, mc, a_prime).slope(), static_cast<double>(slope), 8 * eps) << mc;
    }
  }
}

TEST(Jacobi, CircularLimit) {
  for (const double a_prime : {0.7, std::numeric_limits<double>::infinity()}) {
    const Jacobi jacobi(0, 1, a_prime);
    for (const double u : {-3.0, 0.0, 0.4, 100.0}) {
      const auto v = jacobi.at(u);
      EXPECT_NEAR(v.sn, std::sin(u), 4 * eps * (1 + std::abs(u)));
      EXPECT_NEAR(v.cn, std::cos(u), 4 * eps * (1 + std::abs(u)));
      EXPECT_EQ(v.dn, 1);
      EXPECT_EQ(argument(v), 0);
    }
    EXPECT_EQ(jacobi.slope(), 0);
  }
}

TEST(Jacobi, HyperbolicLimit) {
  const double a_prime = 0.7, x = (std::numbers::pi / 2 - a_prime) / 2;
  const Jacobi jacobi(1, 0, a_prime);
  EXPECT_EQ(jacobi.quarter_period(), std::numeric_limits<double>::infinity());
  for (const double u : {-900.0, -30.0, -0.3, 0.0, 1e-9, 2.0, 1e300}) {
    const auto v = jacobi.at(u);
    EXPECT_NEAR(v.sn, std::tanh(u), 4 * eps);
    EXPECT_NEAR(v.cn, 1 / std::cosh(u), 4 * eps);
    EXPECT_NEAR(v.dn, 1 / std::cosh(u), 4 * eps);
    EXPECT_NEAR(argument(v), std::atan(std::tan(x) * std::tanh(u / 2)), 4 * eps);
  }
  EXPECT_NEAR(jacobi.slope(), std::tan(x) / 2, 2 * eps);
}

TEST(Jacobi, ParametersAtTheEdgeOfDoubles) {
  for (const auto& [m, mc] : {Complement{1, 1e-307}, Complement{1e-307, 1}}) {
    const Jacobi jacobi(m, mc, 1.0);
    const double K = jacobi.quarter_period();
    for (const double u : {0.0, 0.7 * K, K, -1.5 * K, 2e3 * K}) {
      const auto v = jacobi.at(u);
      EXPECT_NEAR(v.sn * v.sn + v.cn * v.cn, 1, 8 * eps);
      EXPECT_NEAR(v.dn * v.dn + m * v.sn * v.sn, 1, 8 * eps);
      EXPECT_TRUE(std::isfinite(argument(v)));
    }
    EXPECT_TRUE(std::isfinite(jacobi.slope()));
  }
}

}  // namespace
}  // namespace twrench::elliptic
