#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <cmath>

#include "motion/scheme.h"

namespace twrench::motion {
namespace {

double sum(const TableauRow& row) {
  double total = 0;
  for (const double x : row) total += x;
  return total;
}

/// Returns the nodes c_k = sum_j a_kj.
TableauRow nodes(const Tableau& tableau) {
  TableauRow c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = sum(tableau.a[k]);
  return c;
}

/// Returns sum_k b_k c_k^power, which is 1/(power + 1) for a tableau of order power + 1.
double quadrature(const TableauRow& weights, const TableauRow& c, int power) {
  double total = 0;
  for (std::size_t k = 0; k < c.size(); ++k) total += weights[k] * std::pow(c[k], power);
  return total;
}

const Tableau& tableau_of(const Method& method) {
  return std::get<RungeKutta>(method.scheme->kind).tableau;
}

std::vector<Method> runge_kutta_methods() {
  std::vector<Method> chosen;
  for (const Method& method : methods()) {
    if (std::holds_alternative<RungeKutta>(method.scheme->kind)) chosen.push_back(method);
  }
  return chosen;
}

TEST(Method, TableausAreExplicit) {
  for (const Method& method : runge_kutta_methods()) {
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t j = k; j < 6; ++j) EXPECT_EQ(tableau_of(method).a[k][j], 0) << method.name;
    }
  }
}

TEST(Method, QuadratureConditionsHoldToTheTableausOrder) {
  for (const Method& method : runge_kutta_methods()) {
    const TableauRow c = nodes(tableau_of(method));
    for (int power = 0; power < tableau_of(method).order; ++power) {
      EXPECT_NEAR(quadrature(tableau_of(method).weights, c, power), 1.0 / (power + 1), 1e-15)
          << method.name << " c^" << power;
    }
  }
}

// Eq. (39): the second row of weights is of order 5, and the nodes are Fehlberg's.
TEST(Method, FehlbergsPair) {
  const Tableau& tableau = tableau_of(find_method("rkf45"));
  const TableauRow expected{0, 1.0 / 4, 3.0 / 8, 12.0 / 13, 1, 1.0 / 2};
  const TableauRow c = nodes(tableau);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(c[k], expected[k], 1e-14);
  for (int power = 0; power < 5; ++power) {
    EXPECT_NEAR(quadrature(tableau.embedded, c, power), 1.0 / (power + 1), 1e-15);
  }
}

// The condition sum b_i a_ij c_j = 1/6 and its companions of order 4. The quadrature conditions do
// not imply them; they reveal a wrong digit inside `a`.
TEST(Method, CoupledConditionsOfTheFourthOrderTableaus) {
  for (const char* name : {"rk4", "rkf45"}) {
    const Tableau& t = tableau_of(find_method(name));
    const TableauRow c = nodes(t);
    double bac = 0, bcac = 0, bacc = 0, baac = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        bac += t.weights[i] * t.a[i][j] * c[j];
        bcac += t.weights[i] * c[i] * t.a[i][j] * c[j];
        bacc += t.weights[i] * t.a[i][j] * c[j] * c[j];
        for (std::size_t k = 0; k < 6; ++k) baac += t.weights[i] * t.a[i][j] * t.a[j][k] * c[k];
      }
    }
    EXPECT_NEAR(bac, 1.0 / 6, 1e-15) << name;
    EXPECT_NEAR(bcac, 1.0 / 8, 1e-15) << name;
    EXPECT_NEAR(bacc, 1.0 / 12, 1e-15) << name;
    EXPECT_NEAR(baac, 1.0 / 24, 1e-15) << name;
  }
}

TEST(Method, UnknownNameOffersTheNearest) {
  try {
    find_method("rk45");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "method: unknown name 'rk45'");
    EXPECT_NE(error.remedy().find("did you mean 'rk"), std::string::npos) << error.remedy();
  }
}

}  // namespace
}  // namespace twrench::motion
