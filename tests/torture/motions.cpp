// torture_motions SECONDS SEED [CASE]: random motions, from nanograms to planets, exactly or nearly
// symmetric, on or near the separatrix. Compares the closed form with Taylor series in more digits,
// with the method `taylor`, and with the conserved quantities; every other method must return
// numbers or an error. Exits with 1 if there was a fault.
//
// Case k depends only on SEED and k; CASE runs and prints a single case.
#include <fmt/format.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "motion/taylor_motion.h"

namespace twrench::torture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Random numbers that are the same with every standard library, unlike those of the standard
/// distributions.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t number) {
    std::seed_seq both{seed & 0xffffffff, seed >> 32, number & 0xffffffff, number >> 32};
    engine_.seed(both);
  }
  double between(double a, double b) {
    return a + (b - a) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  /// A random magnitude from 10^a to 10^b.
  double magnitude(double a, double b) { return std::pow(10, between(a, b)); }
  double sign() { return below(2) == 0 ? 1.0 : -1.0; }

 private:
  std::mt19937_64 engine_;
};

struct Case {
  Vector3d moments;  ///< g cm^2, about x, y, z
  Vector3d omega;    ///< rad/s
  double t;          ///< s
};

/// Ascending; the least is 1.
Vector3d ascending_moments(Random& random) {
  const double offset = random.below(4) == 0 ? 0 : random.magnitude(-16, -1);
  switch (random.below(6)) {
    case 0: {  // a box: each moment is at most the sum of the other two
      const Vector3d s =
          Vector3d(random.between(0.01, 1), random.between(0.01, 1), random.between(0.01, 1))
              .cwiseAbs2();
      Vector3d moments = Vector3d::Constant(s.sum()) - s;
      std::sort(moments.begin(), moments.end());
      return moments / moments[0];
    }
    case 1: {  // a needle
      const double length = random.magnitude(0, 11.9);
      return {1, length, length + random.between(0, 1)};
    }
    case 2: {  // physically impossible
      const double a = random.magnitude(0, 6), b = random.magnitude(0, 5.9);
      return {1, a, a * b};
    }
    case 3:
      return {1, 1 + offset, 1 + random.between(0, 1)};  // nearly oblate
    case 4: {                                            // nearly prolate
      const double b = random.magnitude(0, 3);
      return {1, b, b * (1 + offset / b)};
    }
    default:
      return {1, 1 + offset, 1 + 2 * offset};  // nearly a sphere
  }
}

/// For ascending moments; of length about 1.
Vector3d direction(Random& random, const Vector3d& I) {
  const auto entry = [&] { return random.sign() * random.between(0, 1); };
  const auto small = [&] {
    return random.below(3) == 0 ? 0.0 : random.sign() * random.magnitude(-130, 0);
  };
  switch (random.below(4)) {
    case 0: {  // nearly about an axis
      Vector3d w(small(), small(), small());
      w[random.below(3)] = random.sign();
      return w;
    }
    case 1: {  // nearly on the separatrix, where I_1 (I_2 - I_1) w_1^2 = I_3 (I_3 - I_2) w_3^2
      const double off = random.below(4) == 0 ? 0 : random.sign() * random.magnitude(-16, -1);
      const double ratio = std::sqrt(I[0] / I[2] * ((I[1] - I[0]) / (I[2] - I[1])));
      if (!(ratio > 0 && std::isfinite(ratio))) return {entry(), entry(), entry()};
      const double share = random.below(2) == 0 ? entry() : small();
      return {share * (1 + off), entry(), share * ratio};
    }
    default:
      return {entry(), entry(), entry()};
  }
}

Case random_case(Random& random) {
  const Vector3d moments = ascending_moments(random);
  const Vector3d velocity = direction(random, moments);
  const double mass = random.magnitude(-48, 18), speed = random.magnitude(-100, 11.9);
  const int turn = random.below(6);
  Case c{Vector3d::Zero(), Vector3d::Zero(), 0};
  for (int i = 0; i < 3; ++i) {
    const int to = turn < 3 ? (i + turn) % 3 : (2 * turn - i) % 3;
    c.moments[to] = mass * moments[i];
    c.omega[to] = speed * velocity[i];
  }
  const double angle = random.sign() * random.magnitude(-3, random.below(3) == 0 ? 9 : 2.5);
  c.t = angle / (c.omega.norm() > 0 ? c.omega.norm() : 1);
  return c;
}

/// The quantities that determine the bounds below.
struct Condition {
  double angle;  ///< rad, at least the angle of rotation and lambda t
  double mc;     ///< 1 - k^2 of eq. (E3), the distance from the separatrix
};

/// Returns mc of eq. (E3) for ascending moments and the direction of the momentum.
double complementary_parameter(const Vector3d& I, const Vector3d& mu) {
  const auto D = [&](int i) {
    return (mu.array().square() * (I.array() - I[i]) / I.array()).sum();
  };
  const int a = D(1) > 0 ? 2 : 0, c = 2 - a;
  const double ratio = D(1) / D(c) * ((I[c] - I[a]) / (I[1] - I[a]));
  return std::isfinite(ratio) ? std::min(1.0, std::abs(ratio)) : 0;
}

Condition condition_of(const Case& c, const motion::FreeBody& body,
                       const motion::ExactMotion& exact) {
  const Vector3d I = body.principal().moments / body.principal().moments[0];
  const Vector3d w = body.principal().axes.transpose() * c.omega / c.omega.stableNorm();
  // |omega| <= G/I_1 at all times, and <= sqrt(2T/I_1).
  const Vector3d m = w.cwiseProduct(I);
  double rate = c.omega.stableNorm() * std::min(m.norm(), std::sqrt(w.dot(m)));
  if (const auto flips = exact.flips()) {
    rate = std::max(rate, std::numbers::pi / flips->interval);
    // Near the separatrix lambda is ln(16/mc) divided by this.
    rate = std::max(rate, 2.5 / flips->asymptotic_interval);
  }
  return {std::max(1.0, rate * std::abs(c.t)), complementary_parameter(I, m.normalized())};
}

/// Finds faults in one case.
class Trial {
 public:
  Trial(std::uint64_t seed, std::uint64_t number)
      : seed_(seed), number_(number), random_(seed, number), case_(random_case(random_)) {}

  int faults() {
    try {
      run();
    } catch (const Error& error) {
      fault(fmt::format("refused: {}", error.what()));
    } catch (const std::exception& error) {
      fault(fmt::format("an exception: {}", error.what()));
    }
    return faults_;
  }

  std::string describe() const {
    const auto text = [](const Vector3d& v) {
      return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v[0], v[1], v[2]);
    };
    return fmt::format("moments {} omega {} t {:.17g}", text(case_.moments), text(case_.omega),
                       case_.t);
  }

 private:
  void fault(const std::string& what) {
    ++faults_;
    fmt::print("fault: seed {} case {}: {}; {}\n", seed_, number_, what, describe());
  }

  void expect_within(const char* what, double value, double bound) {
    if (!(value <= bound)) fault(fmt::format("{} is {:.17g}, over {:.17g}", what, value, bound));
  }

  void run() {
    const motion::FreeBody body(case_.moments.asDiagonal(), case_.omega);
    const motion::ExactMotion exact(body);
    const motion::Sample sample = exact.at(case_.t);
    const Condition condition = condition_of(case_, body, exact);
    expect_conserved(body, sample);
    expect_flips(body, exact, condition);
    if (condition.angle <= 400) expect_reference(sample, condition);
    if (condition.angle <= 4000) expect_taylor(body, sample, condition);
    try_another_method(body);
  }

  /// Errors must be only round-off for any t: docs/exact.md promises 6e-15 for the energy.
  void expect_conserved(const motion::FreeBody& body, const motion::Sample& sample) {
    const Vector3d& I = case_.moments;
    const Matrix3d& X = sample.X;
    expect_within("|X^T X - Id|", (X.transpose() * X - Matrix3d::Identity()).norm(), 4e-15);
    const double G = body.momentum().stableNorm();
    if (G == 0) return expect_within("omega at rest", sample.omega.stableNorm(), 0);
    const Vector3d m = I.cwiseProduct(sample.omega) / G;
    expect_within("|X I omega - L|/|L|", (X * m - body.momentum() / G).norm(), 4e-15);
    const Vector3d m0 = body.momentum() / G, scaled = I.minCoeff() * I.cwiseInverse();
    const double energy = m.cwiseAbs2().dot(scaled), energy0 = m0.cwiseAbs2().dot(scaled);
    expect_within("energy's drift", std::abs(energy / energy0 - 1), 8e-15);
  }

  /// Omega's intermediate component must vanish at the predicted times.
  void expect_flips(const motion::FreeBody& body, const motion::ExactMotion& exact,
                    const Condition& condition) {
    const auto flips = exact.flips();
    if (!flips || !(std::abs(case_.t) < 100 * flips->interval)) return;
    double before = 0;
    for (const double t : exact.flip_times(std::abs(case_.t))) {
      if (!(t > before)) fault(fmt::format("a flip at {:.17g} after {:.17g}", t, before));
      before = t;
      const double rate = body.principal().axes.col(1).dot(exact.at(t).omega);
      // All of omega, rotated by the uncertainty of the angle.
      const double bound = 1e-14 * condition.angle / std::abs(case_.t) * condition.angle;
      expect_within("omega at a flip", std::abs(rate), bound);
    }
  }

  /// Compares with Taylor series in more digits: docs/exact.md promises 2e-15 per radian. The
  /// motion is scaled by a power of two to |omega| of about 1.
  void expect_reference(const motion::Sample& sample, const Condition& condition) {
    using Quad = boost::multiprecision::cpp_bin_float_quad;
    const double speed = std::exp2(std::floor(std::log2(case_.omega.stableNorm())));
    if (!(speed > 0)) return;
    const double bound = 2e-15 * condition.angle;
    const auto hold_against = [&](auto reference) {
      reference.advance_to(case_.t * speed);
      expect_within("X against the series", (sample.X - reference.X()).norm(), bound);
      expect_within("omega against the series", (sample.omega / speed - reference.omega()).norm(),
                    bound * condition.angle / std::abs(case_.t * speed));
    };
    // Each flip multiplies the reference's own rounding errors by at most 1/mc, or by exp(lambda
    // t): 64 bits have 11 to spare, 113 bits 60.
    if (condition.mc > 0.01 && std::numeric_limits<long double>::digits >= 64) {
      hold_against(motion::TaylorMotion<long double, 22>(case_.moments, case_.omega / speed));
    } else if (condition.angle <= 40) {
      hold_against(motion::TaylorMotion<Quad, 36>(case_.moments, case_.omega / speed));
    }
  }

  /// Checks the method's own error. For a symmetric body the series converges everywhere, and a
  /// step is as long as 0.4 of the order, about 8 rad. Terms as large as e^8 then cancel, which
  /// 1e-12 per radian covers. A needle has many short steps of a few I_1/G, with 1e-14 each. Near
  /// the separatrix the energy, known to a few eps, determines the time of the next flip, so that
  /// error is 1/mc times larger.
  void expect_taylor(const motion::FreeBody& body, const motion::Sample& sample,
                     const Condition& condition) {
    const double units =
        std::abs(body.momentum().stableNorm() / body.principal().moments[0] * case_.t);
    const double bound = (1e-12 * condition.angle + 5e-15 * units) / std::max(condition.mc, 1e-300);
    // A needle that rotates end over end takes too many steps.
    if (bound > 0.1 || units > 4e4) return;
    const std::array<double, 1> times{case_.t};
    const motion::Sample other =
        motion::integrate(body, motion::find_method("taylor"), {.tolerance = 1e-15}, times)
            .samples[0];
    expect_within("X against taylor", (sample.X - other.X).norm(), bound);
  }

  /// The method must return numbers or an error.
  void try_another_method(const motion::FreeBody& body) {
    const auto all = motion::methods();
    const motion::Method& method =
        all[static_cast<std::size_t>(random_.below(static_cast<int>(all.size())))];
    const motion::StepControl control{
        .step = std::clamp(random_.magnitude(-2, 1) / case_.omega.stableNorm(), 1e-15, 1e6),
        .tolerance = random_.magnitude(-15, 0),
        .max_steps = 2000};
    const std::array<double, 1> times{std::clamp(case_.t, -1e9, 1e9)};
    try {
      const motion::Sample sample = motion::integrate(body, method, control, times).samples[0];
      const motion::Diagnostics d =
          motion::diagnose(body, motion::energy(body.inertia(), body.omega()), sample);
      const bool finite = sample.X.allFinite() && sample.omega.allFinite() &&
                          std::isfinite(d.energy) && std::isfinite(d.energy_drift) &&
                          std::isfinite(d.orthogonality_error) && std::isfinite(d.momentum_error);
      if (!finite) {
        fault(fmt::format("{} with step {:.17g} and tolerance {:.17g} is not finite", method.name,
                          control.step, control.tolerance));
      }
    } catch (const motion::MotionError&) {
    }
  }

  std::uint64_t seed_, number_;
  Random random_;
  Case case_;
  int faults_ = 0;
};

int run(double seconds, std::uint64_t seed) {
  const auto start = std::chrono::steady_clock::now();
  std::uint64_t ran = 0;
  int faults = 0;
  while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
         seconds) {
    faults += Trial(seed, ran++).faults() > 0 ? 1 : 0;
  }
  fmt::print("motions: {} ran, {} faults\n", ran, faults);
  return faults > 0 ? 1 : 0;
}

int run_one(std::uint64_t seed, std::uint64_t number) {
  Trial trial(seed, number);
  fmt::print("case {}: {}\n", number, trial.describe());
  const int faults = trial.faults() > 0 ? 1 : 0;
  fmt::print("motions: 1 ran, {} faults\n", faults);
  return faults;
}

}  // namespace
}  // namespace twrench::torture

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    fmt::print(stderr, "usage: torture_motions SECONDS SEED [CASE]\n");
    return 2;
  }
  const std::uint64_t seed = std::strtoull(argv[2], nullptr, 10);
  if (argc == 4) return twrench::torture::run_one(seed, std::strtoull(argv[3], nullptr, 10));
  return twrench::torture::run(std::strtod(argv[1], nullptr), seed);
}
