#include <fmt/format.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/require.h"
#include "math/unaligned.h"

namespace twrench::motion {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using so3::Matrix4;
using so3::Quaternion;

/// A number of twice the digits of double, as the sum of two.
struct Twofold {
  double high, low;
};

/// a + b, exactly (Knuth).
Twofold exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a b, exactly.
Twofold exact_product(double a, double b) { return {a * b, std::fma(a, b, -(a * b))}; }

Twofold operator*(const Twofold& a, const Twofold& b) {
  const Twofold product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/// D2 / G^2 of eq. (E1) for ascending moments: negative if L circles the axis of least moment,
/// positive if it circles that of greatest moment, zero on the separatrix. It is the only
/// difference in the solution that suffers cancellation, and near the separatrix the flip times
/// depend on its last digit. It is therefore computed from the given velocity, not from the rounded
/// L, and in twice the digits.
double beyond_separatrix(const Vector3d& I, const Vector3d& omega, double G) {
  // With G about 1 nothing overflows. The unit is a power of two, so that nothing is rounded.
  const int unit = -std::ilogb(G);
  const auto term = [&](int i) {
    const double w = std::scalbn(omega[i], unit);
    return exact_product(w, I[i]) * Twofold{w, 0} * exact_sum(I[i], -I[1]);
  };
  const Twofold least = term(0), greatest = term(2), sum = exact_sum(least.high, greatest.high);
  const double size = std::scalbn(G, unit);
  return (sum.high + (sum.low + (least.low + greatest.low))) / (size * size);
}

/// Body axes (a, b, c) as a proper rotation: a is the principal axis `a` (0 or 2), b the
/// intermediate one, and the components of m along a and c are not negative.
Matrix3d motion_axes(const body::PrincipalAxes& principal, int a, const Vector3d& m) {
  Matrix3d axes;
  axes.col(0) = std::copysign(1.0, m[a]) * principal.axes.col(a);
  axes.col(2) = std::copysign(1.0, m[2 - a]) * principal.axes.col(2 - a);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// D_i / G^2 of eq. (E1), where i has the least or the greatest moment: all terms have the same
/// sign.
double excess(const Vector3d& I, const Vector3d& mu, int i) {
  return (mu.array().square() * (I.array() - I[i]) / I.array()).sum();
}

/// The matrices that multiply the quaternion (w, x, y, z) from the left and from the right.
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

}  // namespace

ExactMotion::ExactMotion(const FreeBody& body)
    : start_{0, body.attitude(), body.omega()}, orbit_(steady_orbit(body.omega())) {
  prepare(body);
  // Unless X(0) = Id: a quaternion that is multiplied by 1 might lose the sign of a zero.
  if (body.attitude() == Matrix3d::Identity()) return;
  orbit_.attitude_from_turn = left_product(Quaternion(body.attitude())) * orbit_.attitude_from_turn;
}

void ExactMotion::prepare(const FreeBody& body) {
  // A unit of mass in which the greatest moment is about 1, so that its squares neither overflow
  // nor underflow. It is a power of two, so that nothing is rounded.
  const double unit = std::exp2(-std::ilogb(body.principal().moments[2]));
  const body::PrincipalAxes principal{unit * body.principal().moments, body.principal().axes};
  const Vector3d momentum = unit * body.body_momentum(), m = principal.axes.transpose() * momentum;
  const double G = m.stableNorm();
  if (G == 0) return;
  const double D2 =
      beyond_separatrix(principal.moments, principal.axes.transpose() * body.omega(), G);
  const int a = D2 > 0 ? 2 : 0;
  const Vector3d I(principal.moments[a], principal.moments[1], principal.moments[2 - a]);
  const Matrix3d body_from_motion = motion_axes(principal, a, m);
  const Vector3d mu = body_from_motion.transpose() * momentum / G;
  // Below the smallest normal number D2 has no digits left.
  constexpr double nothing = std::numeric_limits<double>::min();
  if (mu[0] * mu[0] * std::abs(I[1] - I[0]) < nothing || excess(I, mu, 0) == 0) return;
  // A symmetric body has no separatrix: D2 = 0 is spin about any axis of its equator. Products of
  // inertia that are lost in the moments may still tilt L by a rounding error.
  if (D2 == 0 && I[1] == I[2]) return;
  kind_ = D2 < 0 ? Kind::about_least : D2 > 0 ? Kind::about_greatest : Kind::separatrix;
  orbit_ = orbit(G, mu, I, D2);
  orbit_.omega_from_mu = body_from_motion * (G * I.cwiseInverse()).asDiagonal();
  const Quaternion motion_from_body = Quaternion(body_from_motion).conjugate();
  const Quaternion start = turn_at_start(orbit_).normalized() * motion_from_body;
  orbit_.attitude_from_turn = left_product(start.conjugate()) * right_product(motion_from_body);
}

/// The quaternion (cos, sin n) of the rotation about n = omega/|omega| is linear in cos and sin.
ExactMotion::Orbit ExactMotion::steady_orbit(const Vector3d& omega) {
  static const elliptic::Jacobi circle(0, 1, std::numeric_limits<double>::infinity());
  const double speed = omega.stableNorm();
  Orbit orbit{.jacobi = circle,
              .m = 0,
              .mc = 1,
              .rate = 0,
              .phase = 0,
              .quarter_turns = speed / std::numbers::pi,
              .amplitude = Vector3d::UnitX()};
  orbit.attitude_from_turn(0, 0) = 1;
  if (speed > 0) orbit.attitude_from_turn.block<3, 1>(1, 1) = omega / speed;
  orbit.omega_from_mu.col(0) = omega;
  return orbit;
}

ExactMotion::Orbit ExactMotion::orbit(double G, const Vector3d& mu, const Vector3d& I, double D2) {
  const double Da = excess(I, mu, 0), Dc = excess(I, mu, 2);
  const double ab = I[1] - I[0], bc = I[2] - I[1], ac = I[2] - I[0];

  // Eq. (E3); excess divides by G^2, hence amplitude is that of mu = m/G.
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
          .amplitude = amplitude};
}

std::optional<ExactMotion::Flips> ExactMotion::flips() const {
  if (orbit_.m == 0) return std::nullopt;
  const Orbit& o = orbit_;
  const double rate = std::abs(o.rate), phase = std::copysign(1.0, o.rate) * o.phase;
  const double interval = 2 * o.jacobi.quarter_period() / rate;
  const double first = phase < 0 ? -phase / rate : interval - phase / rate;
  // At sn u = 1, L has no component along c, and its component along a is smallest.
  const double swing = 2 * std::atan2(o.amplitude[1], std::sqrt(o.mc) * o.amplitude[0]);
  return Flips{interval, first, (std::log(16) - std::log(o.mc)) / rate, swing, rate, o.mc};
}

std::optional<double> ExactMotion::nutation_period() const {
  if (kind_ == Kind::steady) return std::nullopt;
  return 4 * orbit_.jacobi.quarter_period() / std::abs(orbit_.rate);
}

std::vector<double> ExactMotion::flip_times(double t_end) const {
  require_finite("t_end", t_end);
  std::vector<double> times;
  if (const auto flips = this->flips()) {
    constexpr double most = 1e7;
    if (const double count = t_end / flips->interval; count > most) {
      throw MotionError("flips",
                        fmt::format("there would be {:.3g} in {} s, but at most {:.0f} are allowed",
                                    count, t_end, most),
                        MotionError::Reason::too_many_flips);
    }
    double t = flips->first;
    for (int n = 1; t <= t_end; ++n) {
      times.push_back(t);
      t = flips->first + n * flips->interval;
    }
  }
  return times;
}

}  // namespace twrench::motion
