#include "motion/exact_solution.h"

#include <twrench/base/error.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "body/moments.h"

namespace twrench::motion {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using so3::Matrix4;
using so3::Quaternion;

/// A number with twice the digits of a double, as the sum of two doubles.
struct Twofold {
  double high, low;
};

/// Returns a + b exactly (Knuth).
Twofold exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// Returns a b exactly.
Twofold exact_product(double a, double b) { return {a * b, std::fma(a, b, -(a * b))}; }

Twofold operator*(const Twofold& a, const Twofold& b) {
  const Twofold product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/// Returns D2 / G^2 of eq. (E1) for ascending moments: negative if L circles the axis of least
/// moment, positive if it circles the axis of greatest moment, zero on the separatrix. It is the
/// only difference in the solution that suffers cancellation, and near the separatrix the flip
/// times depend on its last digit. It is therefore computed from the given velocity rather than the
/// rounded L, and with twice the digits.
double separatrix_excess(const Vector3d& I, const Vector3d& omega, double G) {
  // Scaling G to about 1 prevents overflow. The unit is a power of two, so nothing is rounded.
  const int unit = -std::ilogb(G);
  const auto term = [&](int i) {
    const double w = std::scalbn(omega[i], unit);
    return exact_product(w, I[i]) * Twofold{w, 0} * exact_sum(I[i], -I[1]);
  };
  const Twofold least = term(0), greatest = term(2), sum = exact_sum(least.high, greatest.high);
  const double size = std::scalbn(G, unit);
  return (sum.high + (sum.low + (least.low + greatest.low))) / (size * size);
}

/// Returns body axes (a, b, c) as a proper rotation: a is the principal axis `a` (0 or 2), b is the
/// intermediate one, and the components of m along a and c are not negative.
Matrix3d motion_axes(const body::PrincipalAxes& principal, int a, const Vector3d& m) {
  Matrix3d axes;
  axes.col(0) = std::copysign(1.0, m[a]) * principal.axes.col(a);
  axes.col(2) = std::copysign(1.0, m[2 - a]) * principal.axes.col(2 - a);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// Returns D_i / G^2 of eq. (E1), where i has the least or the greatest moment. All terms then have
/// the same sign.
double excess(const Vector3d& I, const Vector3d& mu, int i) {
  return (mu.array().square() * (I.array() - I[i]) / I.array()).sum();
}

/// Returns the matrix of the product with `q` from the left; right_product() does so from the
/// right. Quaternions are (w, x, y, z).
Matrix4 left_product(const Quaternion& q) {
  Matrix4 L;
  L << q.w(), -q.x(), -q.y(), -q.z(),  //
      q.x(), q.w(), -q.z(), q.y(),     //
      q.y(), q.z(), q.w(), -q.x(),     //
      q.z(), -q.y(), q.x(), q.w();
  return L;
}

Matrix4 right_product(const Quaternion& q) {
  Matrix4 R;
  R << q.w(), -q.x(), -q.y(), -q.z(),  //
      q.x(), q.w(), q.z(), -q.y(),     //
      q.y(), -q.z(), q.w(), q.x(),     //
      q.z(), q.y(), -q.x(), q.w();
  return R;
}

/// The axis of a symmetric body, a unit vector in body axes, with the moments along and across it.
struct SymmetryAxis {
  Vector3d direction;
  double along, across;
};

/// Returns the symmetry axis of a body if its wheel turns along it; for a sphere, the axis of the
/// wheel. Nothing for any other body, or if energy is lost.
std::optional<SymmetryAxis> symmetry_axis(const FreeBody& body) {
  const Vector3d& moments = body.principal().moments;
  const Matrix3d& axes = body.principal().axes;
  // Equal to round-off. The deviation of the angles is no larger than that due to the error of the
  // moments.
  constexpr double same = 1e-15;
  const auto alike = [&](int i, int j) {
    return std::abs(moments[i] - moments[j]) <= same * moments[j];
  };
  const Vector3d wheel = body.interior().wheel;
  if (body.energy_loss() > 0) return std::nullopt;
  if (alike(0, 2)) return SymmetryAxis{wheel.stableNormalized(), moments[1], moments[1]};
  for (const int i : {0, 2}) {
    const Vector3d axis = axes.col(i);
    if (alike(2 - i, 1) && wheel.cross(axis).stableNorm() <= same * wheel.stableNorm()) {
      return SymmetryAxis{axis, moments[i], moments[1]};
    }
  }
  return std::nullopt;
}

}  // namespace

bool ExactSolution::covers(const FreeBody& body) {
  return body.is_rigid() || symmetry_axis(body).has_value();
}

ExactSolution::ExactSolution(const FreeBody& body)
    : start_{0, body.attitude(), body.omega()}, orbit_(steady_orbit(body.omega())) {
  body.is_rigid() ? prepare(body) : prepare_with_wheel(body);
  // Not if X(0) = Id, because multiplying a quaternion by 1 might lose the sign of a zero.
  if (body.attitude() == Matrix3d::Identity()) return;
  orbit_.attitude_from_turn = left_product(Quaternion(body.attitude())) * orbit_.attitude_from_turn;
}

void ExactSolution::prepare(const FreeBody& body) {
  // In this unit of mass the greatest moment is about 1, so that its squares neither overflow nor
  // underflow. It is a power of two, so nothing is rounded.
  const double unit = std::exp2(-std::ilogb(body.principal().moments[2]));
  const body::PrincipalAxes principal{unit * body.principal().moments, body.principal().axes};
  const Vector3d momentum = unit * body.body_momentum(), m = principal.axes.transpose() * momentum;
  const double G = m.stableNorm();
  if (G == 0) return;
  const double D2 =
      separatrix_excess(principal.moments, principal.axes.transpose() * body.omega(), G);
  const int a = D2 > 0 ? 2 : 0;
  const Vector3d I(principal.moments[a], principal.moments[1], principal.moments[2 - a]);
  const Matrix3d body_from_motion = motion_axes(principal, a, m);
  const Vector3d mu = body_from_motion.transpose() * momentum / G;
  // Below the smallest normal number D2 has no digits left.
  constexpr double least_normal = std::numeric_limits<double>::min();
  if (mu[0] * mu[0] * std::abs(I[1] - I[0]) < least_normal || excess(I, mu, 0) == 0) return;
  // A symmetric body has no separatrix; D2 = 0 means spin about an axis in its equator. Products of
  // inertia too small to affect the moments may still tilt L by a rounding error.
  if (D2 == 0 && I[1] == I[2]) return;
  has_intermediate_axis_ = !body::are_equal_moments(principal.moments[0], principal.moments[1]) &&
                           !body::are_equal_moments(principal.moments[1], principal.moments[2]);
  kind_ = D2 < 0   ? ExactMotion::Kind::about_least
          : D2 > 0 ? ExactMotion::Kind::about_greatest
                   : ExactMotion::Kind::separatrix;
  orbit_ = orbit(G, mu, I, D2);
  orbit_.omega_from_mu = body_from_motion * (G * I.cwiseInverse()).asDiagonal();
  const Quaternion motion_from_body = Quaternion(body_from_motion).conjugate();
  const Quaternion start = turn_at_start(orbit_).normalized() * motion_from_body;
  orbit_.attitude_from_turn = left_product(start.conjugate()) * right_product(motion_from_body);
}

/// Eq. (T3) of docs/theory.md, for a symmetric body with a wheel along its axis e:
/// X(t) = exp(t hat(L)/A) X(0) exp(t nu hat(e)). The quaternion of this product is linear in the
/// cosines and sines of half the sum and half the difference of the two angles.
void ExactSolution::prepare_with_wheel(const FreeBody& body) {
  const auto axis = symmetry_axis(body);
  if (!axis) {
    throw InvalidArgument(
        "method exact",
        "there is no closed form with energy loss, or with a wheel that is not along "
        "the axis of a symmetric body",
        "use the method taylor");
  }
  const Vector3d m = body.body_momentum();
  const double along = axis->along, across = axis->across;
  const Vector3d e = std::copysign(1.0, axis->direction.dot(m)) * axis->direction;
  const Vector3d transverse = m - e.dot(m) * e;
  if (transverse.isZero(0.0)) return;
  kind_ = along < across ? ExactMotion::Kind::about_least : ExactMotion::Kind::about_greatest;
  const double spin = e.dot(body.omega());
  const double nu = ((across - along) * spin - e.dot(body.interior().wheel)) / across;
  const double G = m.stableNorm();
  orbit_.rate = nu;
  orbit_.quarter_turns = (G / across + nu) / std::numbers::pi;
  orbit_.dynamic_rate = body.omega().dot(m) / G;
  orbit_.amplitude = Vector3d::Ones();
  const Vector3d l = m / G, le = l.cross(e);
  orbit_.attitude_from_turn.col(0) << 0.25 * (1 + l.dot(e)), -0.25 * le;
  orbit_.attitude_from_turn.col(1) << 0, 0.25 * (e + l);
  orbit_.attitude_from_turn.col(2) << 0.5 * (1 - l.dot(e)), 0.5 * le;
  orbit_.attitude_from_turn.col(3) << 0, 0.5 * (l - e);
  orbit_.omega_from_mu << spin * e, -e.cross(transverse) / across, transverse / across;
}

/// The quaternion (cos, sin n) of the rotation about n = omega/|omega| is linear in cos and sin.
ExactSolution::Orbit ExactSolution::steady_orbit(const Vector3d& omega) {
  static const elliptic::Jacobi circle(0, 1, std::numeric_limits<double>::infinity());
  const double speed = omega.stableNorm();
  Orbit orbit{.jacobi = circle,
              .m = 0,
              .mc = 1,
              .rate = 0,
              .phase = 0,
              .quarter_turns = speed / std::numbers::pi,
              .dynamic_rate = speed,
              .amplitude = Vector3d::UnitX()};
  orbit.attitude_from_turn(0, 0) = 1;
  if (speed > 0) orbit.attitude_from_turn.block<3, 1>(1, 1) = omega / speed;
  orbit.omega_from_mu.col(0) = omega;
  return orbit;
}

ExactSolution::Orbit ExactSolution::orbit(double G, const Vector3d& mu, const Vector3d& I,
                                          double D2) {
  const double Da = excess(I, mu, 0), Dc = excess(I, mu, 2);
  const double ab = I[1] - I[0], bc = I[2] - I[1], ac = I[2] - I[0];

  // Eq. (E3). As excess() divides by G^2, these are the amplitudes of mu = m/G.
  const Vector3d amplitude(std::sqrt(-I[0] * Dc / ac), std::sqrt(I[1] * Da / ab),
                           std::sqrt(I[2] * Da / ac));
  const double m = -Da * bc / (Dc * ab), mc = std::abs(D2 / Dc * (ac / ab));
  const double rate =
      std::copysign(G / I[0] * amplitude[0] * std::sqrt(ab / I[1] * (ac / I[2])), ac);

  // Eq. (E4): the phase at t = 0.
  const double s = mu[1], c = mu[2] * std::sqrt(I[1] * ac / (I[2] * ab)), size = std::hypot(s, c);
  const double phase = elliptic::incomplete_first(s / size, c / size, mc);

  // Eq. (E8).
  const double pole = elliptic::incomplete_first(amplitude[0], amplitude[2], m);
  const elliptic::Jacobi jacobi(m, mc, pole);

  // Eq. (E9).
  const double energy = (mu.array().square() / I.array()).sum();
  const double spin =
      G * (energy + amplitude[0] / I[0]) / (1 + amplitude[0]) - 2 * rate * jacobi.slope();  // rad/s
  return {.jacobi = jacobi,
          .m = m,
          .mc = mc,
          .rate = rate,
          .phase = phase,
          .quarter_turns = spin / std::numbers::pi,
          .dynamic_rate = G * energy,
          .amplitude = amplitude};
}

std::optional<ExactMotion::Flips> ExactSolution::flips() const {
  if (orbit_.m == 0 || !has_intermediate_axis_) return std::nullopt;
  const Orbit& o = orbit_;
  const double rate = std::abs(o.rate), phase = std::copysign(1.0, o.rate) * o.phase;
  const double interval = 2 * o.jacobi.quarter_period() / rate;
  const double first = phase < 0 ? -phase / rate : interval - phase / rate;
  // At sn u = 1, L has no component along c, and its component along a is smallest.
  const double swing = 2 * std::atan2(o.amplitude[1], std::sqrt(o.mc) * o.amplitude[0]);
  return ExactMotion::Flips{interval, first, (std::log(16) - std::log(o.mc)) / rate,
                            swing,    rate,  o.mc};
}

std::optional<double> ExactSolution::nutation_period() const {
  if (kind_ == ExactMotion::Kind::steady) return std::nullopt;
  return 4 * orbit_.jacobi.quarter_period() / std::abs(orbit_.rate);
}

/// Whole periods of the theta function do not add to psi of eq. (E7), so over a period of the
/// momentum psi grows at its mean rate. Written as the integral of eq. (E6), this is the dynamic
/// angle minus the area (docs/theory.md).
std::optional<ExactMotion::Phase> ExactSolution::phase() const {
  const auto period = nutation_period();
  if (!period || !std::isfinite(*period)) return std::nullopt;
  return ExactMotion::Phase{.period = *period,
                            .total = std::numbers::pi * orbit_.quarter_turns * *period,
                            .dynamic = orbit_.dynamic_rate * *period};
}

}  // namespace twrench::motion
