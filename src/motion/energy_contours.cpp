#include "motion/energy_contours.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>

namespace twrench::motion {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Kind = EnergyContours::Kind;

/// Differences of coefficients, and components of D eta, below which they count as zero.
constexpr double nothing = 1e-12;
constexpr double longest_step = 0.025, shortest_step = 1e-4;  // rad
constexpr int most_steps = 20'000;

/// Two tangents that form a right-handed frame with mu.
struct Tangents {
  explicit Tangents(const Vector3d& mu) : a(mu.unitOrthogonal()), b(mu.cross(a)) {}
  Vector3d a, b;
};

/// Returns the root of a continuous function between two points where its signs differ.
double root(const std::function<double(double)>& f, double low, double high) {
  const boost::math::tools::eps_tolerance<double> tight(std::numeric_limits<double>::digits - 2);
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, tight, iterations);
  return 0.5 * (a + b);
}

/// The term (c/(d - lambda))^2 of the secular equation.
struct Pole {
  double d, c;
};

/// Returns the roots of sum (c/(d - lambda))^2 = 1. The poles must ascend and differ, and no c may
/// be zero. There is one root below all poles, one above, and two or none between two neighbours,
/// because the sum is convex there.
std::vector<double> secular_roots(const std::vector<Pole>& poles) {
  const auto excess = [&](double lambda) {
    double sum = -1;
    for (const Pole& pole : poles) sum += std::pow(pole.c / (pole.d - lambda), 2);
    return sum;
  };
  const auto slope = [&](double lambda) {
    double sum = 0;
    for (const Pole& pole : poles) sum += pole.c * pole.c / std::pow(pole.d - lambda, 3);
    return sum;
  };
  double reach = 0;  // No root is farther from all poles.
  for (const Pole& pole : poles) reach += 2 * std::abs(pole.c);
  // Within this fraction of |c| from its pole, the term alone exceeds 1.
  constexpr double inside = 0.5;
  const auto after = [&](const Pole& pole) { return pole.d + inside * std::abs(pole.c); };
  const auto before = [&](const Pole& pole) { return pole.d - inside * std::abs(pole.c); };
  std::vector<double> roots{root(excess, poles.front().d - reach, before(poles.front())),
                            root(excess, after(poles.back()), poles.back().d + reach)};
  for (std::size_t i = 0; i + 1 < poles.size(); ++i) {
    const double low = after(poles[i]), high = before(poles[i + 1]);
    if (low >= high || slope(low) >= 0 || slope(high) <= 0) continue;
    const double least = root(slope, low, high);
    if (excess(least) >= 0) continue;
    roots.push_back(root(excess, low, least));
    roots.push_back(root(excess, least, high));
  }
  return roots;
}

}  // namespace

EnergyContours::EnergyContours(const FreeBody& body)
    : d_(body.principal().moments[0] * body.principal().moments.cwiseInverse()),
      eta_(body.principal().axes.transpose() *
           (body.interior().wheel / body.momentum().stableNorm())),
      stiffness_(d_.maxCoeff() - d_.minCoeff() + d_.cwiseProduct(eta_).norm()) {
  find_equilibria();
}

double EnergyContours::energy(const Vector3d& mu) const {
  return 0.5 * (mu - eta_).dot(d_.cwiseProduct(mu - eta_));
}

Vector3d EnergyContours::gradient(const Vector3d& mu) const { return d_.cwiseProduct(mu - eta_); }

Vector3d EnergyContours::gradient_along_sphere(const Vector3d& mu) const {
  const Vector3d g = gradient(mu);
  return g - g.dot(mu) * mu;
}

/// At an equilibrium gradient(mu) = lambda mu, so that (d_i - lambda) mu_i = d_i eta_i.
void EnergyContours::find_equilibria() {
  const Vector3d c = d_.cwiseProduct(eta_);
  const double scale = std::max(1.0, c.cwiseAbs().maxCoeff());
  std::vector<Pole> poles;  // The moments ascend, so that d descends.
  for (int i = 2; i >= 0; --i) {
    if (!poles.empty() && d_[i] - poles.back().d <= nothing) {
      poles.back().c = std::hypot(poles.back().c, c[i]);
    } else {
      poles.push_back({d_[i], c[i]});
    }
  }
  const auto is_nothing = [&](const Pole& pole) { return std::abs(pole.c) <= nothing * scale; };
  std::vector<Pole> steep;
  std::ranges::remove_copy_if(poles, std::back_inserter(steep), is_nothing);
  if (!steep.empty()) {
    for (const double lambda : secular_roots(steep)) {
      Vector3d mu;
      for (int i = 0; i < 3; ++i) {
        mu[i] = std::abs(c[i]) <= nothing * scale ? 0 : c[i] / (d_[i] - lambda);
      }
      add_equilibrium(lambda, mu);
    }
  }
  // With lambda = d_i, mu_i is free. Two equal d have a circle of equilibria.
  for (int i = 0; i < 3; ++i) {
    const auto alike = [&](int j) { return j != i && std::abs(d_[j] - d_[i]) <= nothing; };
    if (std::abs(c[i]) > nothing * scale || alike((i + 1) % 3) || alike((i + 2) % 3)) continue;
    Vector3d mu = Vector3d::Zero();
    for (const int j : {(i + 1) % 3, (i + 2) % 3}) mu[j] = c[j] / (d_[j] - d_[i]);
    const double square = 1 - mu.squaredNorm();
    if (!(square > nothing)) continue;
    for (const double side : {1.0, -1.0}) {
      mu[i] = side * std::sqrt(square);
      add_equilibrium(d_[i], mu);
    }
  }
}

void EnergyContours::add_equilibrium(double multiplier, const Vector3d& mu) {
  const Tangents t(mu.normalized());
  const Vector3d h = d_.array() - multiplier;  // The Hessian along the sphere is diag(h).
  const double aa = t.a.dot(h.cwiseProduct(t.a)), ab = t.a.dot(h.cwiseProduct(t.b)),
               bb = t.b.dot(h.cwiseProduct(t.b));
  const Kind kind = aa * bb < ab * ab ? Kind::saddle : aa + bb > 0 ? Kind::minimum : Kind::maximum;
  // There are at most six; a stable sort would add 2 kB to every page.
  equilibria_.insert(std::ranges::upper_bound(equilibria_, kind, {}, &Equilibrium::kind),
                     {mu.normalized(), kind});
}

/// Around an equilibrium, curves are as small as the gradient. A sphere without a wheel has none.
double EnergyContours::step_at(const Vector3d& mu) const {
  if (stiffness_ == 0) return 0;
  return std::min(longest_step, 0.2 * gradient_along_sphere(mu).norm() / stiffness_);
}

/// Returns the direction of the motion, m' = m x w, without its speed.
Vector3d EnergyContours::direction(const Vector3d& mu) const {
  return mu.cross(gradient(mu)).normalized();
}

/// Takes a step of the classical Runge-Kutta method along the curve, and then returns to its level.
Vector3d EnergyContours::advanced(const Vector3d& mu, double step, double level) const {
  const Vector3d k1 = direction(mu), k2 = direction(mu + 0.5 * step * k1),
                 k3 = direction(mu + 0.5 * step * k2), k4 = direction(mu + step * k3);
  Vector3d next = (mu + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)).normalized();
  for (int i = 0; i < 2; ++i) {
    const Vector3d g = gradient_along_sphere(next);
    const Vector3d correction = (level - energy(next)) / g.squaredNorm() * g;
    if (!(correction.norm() < step)) break;  // too close to a saddle
    next = (next + correction).normalized();
  }
  return next;
}

EnergyContours::Curve EnergyContours::through(const Vector3d& mu) const {
  Curve curve{mu};
  if (step_at(mu) < shortest_step) return curve;
  const double level = energy(mu);
  const Vector3d start = direction(mu);
  for (int i = 0; i < most_steps; ++i) {
    const Vector3d& last = curve.back();
    const double step = std::max(step_at(last), shortest_step);
    const Vector3d next = advanced(last, step, level);
    const bool passes = start.dot(last - mu) < 0 && start.dot(next - mu) >= 0;
    if (passes && (next - mu).norm() < 2 * step) break;
    curve.push_back(next);
  }
  curve.push_back(mu);
  return curve;
}

EnergyContours::Curve EnergyContours::leaving(const Vector3d& saddle, const Vector3d& along) const {
  constexpr double start = 2e-3, arrived = 4e-3, away = 2e-2;
  Curve curve{saddle, (saddle + start * along).normalized()};
  const double level = energy(saddle);
  const auto distance = [](const Vector3d& mu) {
    return [&](const Equilibrium& e) {
      return e.kind == Kind::saddle ? (e.mu - mu).norm() : std::numeric_limits<double>::infinity();
    };
  };
  bool has_left = false;
  for (int i = 0; i < most_steps; ++i) {
    const Vector3d& last = curve.back();
    const Vector3d next = advanced(last, std::max(step_at(last), shortest_step), level);
    const auto nearest = std::ranges::min_element(equilibria_, {}, distance(next));
    const double left = distance(next)(*nearest);
    has_left = has_left || left > away;
    if (has_left && left < arrived) {
      curve.push_back(nearest->mu);
      return curve;
    }
    curve.push_back(next);
  }
  return curve;
}

std::vector<EnergyContours::Curve> EnergyContours::separatrices() const {
  std::vector<Curve> curves;
  for (const Equilibrium& e : equilibria_) {
    if (e.kind != Kind::saddle) continue;
    // The flow about the equilibrium in the frame of the tangents: mu x a = b, mu x b = -a.
    const Tangents t(e.mu);
    const Vector3d h = d_.array() - gradient(e.mu).dot(e.mu);
    Matrix2d flow;
    flow << -t.b.dot(h.cwiseProduct(t.a)), -t.b.dot(h.cwiseProduct(t.b)),
        t.a.dot(h.cwiseProduct(t.a)), t.a.dot(h.cwiseProduct(t.b));
    // Its eigenvalues are r and -r, so (flow + r) maps any vector to the direction that grows.
    const double r = std::sqrt(std::max(0.0, -flow.determinant()));
    const Matrix2d growing = flow + r * Matrix2d::Identity();
    const Vector2d v = growing.col(growing.col(0).norm() > growing.col(1).norm() ? 0 : 1);
    const Vector3d along = (v[0] * t.a + v[1] * t.b).normalized();
    curves.push_back(leaving(e.mu, along));
    curves.push_back(leaving(e.mu, -along));
  }
  return curves;
}

std::vector<EnergyContours::Level> EnergyContours::family(double spacing) const {
  std::vector<Level> levels;
  const auto is_free = [&](const Vector3d& mu) {
    const auto is_near = [&](const Vector3d& point) {
      return (point - mu).squaredNorm() < 0.64 * spacing * spacing;
    };
    return std::ranges::none_of(
               levels, [&](const Level& l) { return std::ranges::any_of(l.curve, is_near); }) &&
           std::ranges::none_of(equilibria_, [&](const Equilibrium& e) { return is_near(e.mu); });
  };
  const auto add_between = [&](const Equilibrium& extremum, const Vector3d& other, double depth) {
    const double angle = std::acos(std::clamp(extremum.mu.dot(other), -1.0, 1.0));
    if (angle < spacing) return;
    // Any great circle through opposite points will do.
    Vector3d across = other - other.dot(extremum.mu) * extremum.mu;
    across = across.norm() < 1e-6 ? extremum.mu.unitOrthogonal() : across.normalized();
    for (double along = spacing; along < angle; along += spacing) {
      const Vector3d mu = std::cos(along) * extremum.mu + std::sin(along) * across;
      if (std::abs(energy(mu) - energy(extremum.mu)) > depth || !is_free(mu)) continue;
      Curve curve = through(mu);
      if (curve.size() > 1) levels.push_back({std::move(curve), extremum});
    }
  };
  // First the curves around each extremum alone, up to the nearest saddle.
  constexpr double any = std::numeric_limits<double>::infinity();
  for (const bool alone : {true, false}) {
    for (const Equilibrium& extremum : equilibria_) {
      if (extremum.kind == Kind::saddle) continue;
      double depth = any;
      for (const Equilibrium& other : equilibria_) {
        if (!alone || other.kind != Kind::saddle) continue;
        depth = std::min(depth, std::abs(energy(other.mu) - energy(extremum.mu)));
      }
      for (const Equilibrium& other : equilibria_) add_between(extremum, other.mu, depth);
    }
  }
  return levels;
}

}  // namespace twrench::motion
