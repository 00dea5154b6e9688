// Compares the numbers of the tasks in the report with independent ones: the reference motions of
// 60 digits, the values in the specification, and second implementations of the methods in this
// file.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>

#include "cli/twrench.h"
#include "motion/reference.h"
#include "sanitizers.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Row = std::vector<std::string>;

/// The cells of the first table of a report in Markdown whose caption contains the text.
std::vector<Row> table(const std::string& report, const std::string& caption) {
  std::istringstream lines(report.substr(std::min(report.find(caption), report.size())));
  std::vector<Row> rows;
  std::string line;
  while (std::getline(lines, line) && (rows.empty() || !line.empty())) {
    if (!line.starts_with("| ")) continue;
    std::istringstream cells(line.substr(2));
    Row row;
    for (std::string cell; std::getline(cells, cell, '|');) {
      const std::size_t last = cell.find_last_not_of(' ');
      const std::size_t first = cell.find_first_not_of(' ');
      row.push_back(last == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    rows.push_back(row);
  }
  EXPECT_GT(rows.size(), 1U) << caption;
  return rows;
}

/// The number in the row that begins with the name.
double value(const std::vector<Row>& rows, const std::string& name, std::size_t column = 1) {
  for (const Row& row : rows) {
    if (row.at(0) == name) return std::stod(row.at(column));
  }
  ADD_FAILURE() << "no row " << name;
  return NAN;
}

Matrix3d rotation(const Vector3d& u) {
  return u.isZero() ? Matrix3d(Matrix3d::Identity())
                    : Eigen::AngleAxisd(u.norm(), u.normalized()).toRotationMatrix();
}

/// The angular velocity for an attitude.
using Velocity = std::function<Vector3d(const Matrix3d&)>;
using StepFunction = std::function<Matrix3d(const Matrix3d&, double, const Velocity&)>;

Matrix3d lie_euler_step(const Matrix3d& W, double h, const Velocity& omega) {
  return W * rotation(h * omega(W));
}

/// Section 4.4 of the specification.
Matrix3d rk4_step(const Matrix3d& W, double h, const Velocity& omega) {
  const Vector3d s1 = omega(W), s2 = omega(W * rotation(h / 2 * s1)),
                 s3 = omega(W * rotation(h / 2 * s2)), s4 = omega(W * rotation(h * s3));
  return W * rotation(h / 6 * (s1 + 2 * s2 + 2 * s3 + s4));
}

/// The error of a method at the time of a reference sample.
double error_of(const StepFunction& step, double h, const motion::ReferenceCase& reference,
                double t) {
  const Velocity omega = [&](const Matrix3d& W) -> Vector3d {
    return reference.body.inertia().inverse() * W.transpose() * reference.body.momentum();
  };
  Matrix3d W = Matrix3d::Identity();
  for (int n = 0; n < std::lround(t / h); ++n) W = step(W, h, omega);
  for (const motion::Sample& sample : reference.samples) {
    if (sample.t == t) return (W - sample.X).norm();
  }
  ADD_FAILURE() << "no reference at " << t;
  return NAN;
}

class ReportOfTasks : public testing::Test {
 protected:
  void SetUp() override {
    if (has_sanitizers) GTEST_SKIP() << "computes numbers that the transcripts have";
    if (!report_.empty()) return;  // the first test writes it
    const ScratchFolder folder;
    const Outcome run = run_twrench(folder, "report --duration 20 -o a.md");
    ASSERT_EQ(run.code, 0) << run.err;
    report_ = text_of(folder / "a.md");
  }
  inline static std::string report_;
};

TEST_F(ReportOfTasks, TestsTheExponential) {
  const auto rows = table(report_, "exp(hΩ) for ω");
  double largest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    for (std::size_t k = 1; k <= 3; ++k) largest = std::max(largest, std::stod(rows[i].at(k)));
  }
  EXPECT_LT(largest, 3e-15);
  const std::string before = "The largest error is ";
  EXPECT_EQ(std::stod(report_.substr(report_.find(before) + before.size())), largest);
}

TEST_F(ReportOfTasks, HasTheEnergiesAndTheInertia) {
  const auto inertia = table(report_, "The moments of inertia of the T-wrench");
  const auto energies = table(report_, "The energy at t = 0 and its parts");
  const auto parts = table(report_, "The T-wrench: two cylinders");
  EXPECT_EQ(inertia.at(1).at(1), "982.271303");  // as the specification gives them
  EXPECT_EQ(inertia.at(2).at(1), "722.671030");
  EXPECT_EQ(inertia.at(3).at(1), "1578.650308");
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_EQ(inertia[i].at(1), inertia[i].at(2));
  EXPECT_NEAR(value(parts, "Both", 4), 12 * std::acos(-1) * 6.7, 1e-5);
  for (const auto& [scene, name] :
       {std::pair{"dzhanibekov", "wrench-a"}, {"stable-y", "wrench-b"}, {"stable-z", "wrench-c"}}) {
    const motion::FreeBody body = motion::reference_case(name).body;
    EXPECT_NEAR(value(energies, scene, 4), 0.5 * body.omega().dot(body.momentum()), 1e-5);
  }
}

TEST_F(ReportOfTasks, SolvesTheSphere) {
  const auto rows = table(report_, "The solution at three times");
  EXPECT_NEAR(value(rows, "10", 1), -0.83907153, 1e-8);   // cos 10
  EXPECT_NEAR(value(rows, "100", 4), -0.50636564, 1e-8);  // sin 100
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_LT(std::stod(rows.at(i).at(5)), 1e-13);
  const auto errors = table(report_, "The sphere: errors after 100 s");
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_LT(std::stod(errors.at(i).at(1)), 1e-11);
  EXPECT_NEAR(value(errors, "0.001", 3) / value(errors, "0.01", 3), 0.1, 0.03);
}

// "%.2e" leaves three digits.
TEST_F(ReportOfTasks, HasTheErrorsOfTheMethodsAsPrinted) {
  const motion::ReferenceCase a = motion::reference_case("wrench-a");
  const auto order = table(report_, "dzhanibekov: error of X at 10 s by step");
  const auto rk4 = table(report_.substr(report_.find("## Task 4")), "error of X at 10 s by step");
  const auto energy = table(report_, "rk4: energy drift and error of X after 20 s");
  for (const auto& [name, h] : {std::pair{"0.1", 0.1}, {"0.05", 0.05}, {"0.025", 0.025}}) {
    const double lie = error_of(lie_euler_step, h, a, 10), early = error_of(rk4_step, h, a, 10),
                 end = error_of(rk4_step, h, a, 20);
    EXPECT_NEAR(value(order, name, 2), lie, 0.006 * lie);
    EXPECT_NEAR(value(rk4, name, 2), early, 0.006 * early);
    EXPECT_NEAR(value(energy, name, 2), end, 0.006 * end);
  }
  EXPECT_NEAR(value(rk4, "Measured order", 1), 1, 0.03);
  EXPECT_NEAR(value(rk4, "Measured order", 2), 2, 0.03);
  EXPECT_NEAR(value(rk4, "Measured order", 3), 4, 0.05);
}

TEST_F(ReportOfTasks, TakesAStepThatKeepsTheEnergy) {
  const auto errors = table(report_, "rk4: energy drift and error of X");
  const auto drift = table(report_, "Drift in 20 s");
  const std::string chosen = drift.at(0).at(1);  // "rk4, 0.0125 s"
  const std::string step = chosen.substr(5, chosen.size() - 7);
  EXPECT_LE(value(errors, step), 1e-6);
  EXPECT_GT(value(errors, fmt::format("{:.6g}", 2 * std::stod(step))), 1e-6);
  EXPECT_EQ(value(drift, "Energy drift"), value(errors, step));
}

TEST_F(ReportOfTasks, HasTheConstantsOfTheMotion) {
  const auto rows = table(report_.substr(report_.find("### (a) The Dzhanibekov")), "The motion:");
  const Vector3d I = motion::reference_case("wrench-a").body.inertia().diagonal();
  const double Iy = I[1], Ix = I[0], Iz = I[2];  // ascending
  const Vector3d L(Ix, 0.05 * Iy, 0);
  const double G2 = L.squaredNorm(), T2 = Ix + 0.0025 * Iy;
  const double D2 = G2 - T2 * Ix, D3 = G2 - T2 * Iz;
  const double lambda = std::sqrt((Ix - Iy) * -D3 / (Ix * Iy * Iz));
  const double mc = D2 * (Iz - Iy) / (D3 * (Ix - Iy));
  const double K = std::comp_ellint_1(std::sqrt(1 - mc));
  EXPECT_NEAR(value(rows, "λ"), lambda, 1e-7 * lambda);
  EXPECT_NEAR(value(rows, "1 − m"), mc, 1e-7 * mc);
  EXPECT_NEAR(value(rows, "Time between flips, 2K(m)/λ"), 2 * K / lambda, 1e-6);
  EXPECT_NEAR(value(rows, "Time between flips, 2K(m)/λ"), 23.630725246383, 1e-6);
  EXPECT_NEAR(value(rows, "First sign change of ω₂, t₁"), K / lambda,
              1e-6);  // |ω₂| is largest at 0
  EXPECT_THAT(rows.at(3).at(1), testing::HasSubstr("(982.2713, 36.133552, 0)"));
}

}  // namespace
}  // namespace twrench
