// Follows "Add a method" in CONTRIBUTING.md as a newcomer would. A method is data, and the program
// only needs a line in its list.
#include <gtest/gtest.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "motion/reference.h"
#include "motion/scheme.h"

namespace twrench::motion {
namespace {

/// Heun, Z. Math. Phys. 45 (1900).
constexpr Tableau heun{.stages = 3,
                       .order = 3,
                       .a = {{{}, {1.0 / 3}, {0.0, 2.0 / 3}}},
                       .weights = {1.0 / 4, 0.0, 3.0 / 4}};

constexpr Scheme corrected_heun{RungeKutta{Update::munthe_kaas, heun}};

constexpr Method rkmk3{"rkmk3",
                       &corrected_heun,
                       3,
                       false,
                       false,
                       "Munthe-Kaas, Appl. Numer. Math. 29 (1999)",
                       "Heun's method of order 3 with the commutator correction"};

/// Returns the Frobenius error of X(20) of the T-wrench, in steps of `step` s.
double error_with(double step) {
  const FreeBody wrench = reference_case("wrench-a").body;
  const std::array times{20.0};
  const Trajectory motion = integrate(wrench, rkmk3, {.step = step}, times);
  return (motion.samples.front().X - ExactMotion(wrench).at(times[0]).X).norm();
}

TEST(MethodRecipe, GivesAMethodOfItsOrder) {
  for (const double step : {0.04, 0.02, 0.01}) {
    const double slope = std::log2(error_with(step) / error_with(step / 2));
    EXPECT_GT(slope, *rkmk3.order - 0.1) << step;
    EXPECT_LT(slope, *rkmk3.order + 0.3) << step;
  }
}

TEST(MethodRecipe, GivesAMethodThatStaysOnTheGroup) {
  const std::array times{96.0};
  const Trajectory motion = integrate(reference_case("wrench-a").body, rkmk3, {}, times);
  const Eigen::Matrix3d& X = motion.samples.front().X;
  EXPECT_LE((X.transpose() * X - Eigen::Matrix3d::Identity()).norm(), 1e-10);
}

// The last step of the recipe, for the existing methods.
TEST(MethodRecipe, HasARowAndAParagraphInTheDocumentForEachMethod) {
  std::ifstream file(TWRENCH_TESTS_DIR "/../docs/methods.md");
  std::ostringstream text;
  text << file.rdbuf();
  for (const Method& method : methods()) {
    EXPECT_NE(text.str().find("\n| `" + std::string(method.name) + "` | "), std::string::npos)
        << method.name << " has no row in docs/methods.md";
    EXPECT_NE(text.str().find("**" + std::string(method.name) + "**"), std::string::npos)
        << method.name << " has no paragraph in docs/methods.md";
  }
}

}  // namespace
}  // namespace twrench::motion
