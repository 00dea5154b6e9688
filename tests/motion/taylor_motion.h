#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace twrench::motion {

/// Solves Euler's equations and the attitude by Taylor series in a wide type. It is slow, but
/// independent of the closed form. The inertia is diagonal, with moments in any order; X(0) = Id.
template <typename Real, std::size_t order>
class TaylorMotion {
 public:
  TaylorMotion(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t k) { return Real(moments[static_cast<int>(k % 3)]); };
      euler_[i] = (at(i + 1) - at(i + 2)) / at(i);
      state_[i] = Real(omega[static_cast<int>(i)]);
    }
    state_[3] = 1;
  }

  void advance_to(double t) {
    while (t_ != Real(t)) {
      expand();
      const Real left = Real(t) - t_, h = std::min(reach(), Real(left < 0 ? -left : left));
      const bool last = h == left || h == -left;
      const Real step = left < 0 ? Real(-h) : h;
      for (std::size_t i = 0; i < 7; ++i) {
        Real value = 0;
        for (std::size_t n = order + 1; n-- > 0;) {
          value = series_[n][i] + step * value;
        }
        state_[i] = value;
      }
      t_ = last ? Real(t) : Real(t_ + step);
    }
  }

  Eigen::Vector3d omega() const { return {as_double(0), as_double(1), as_double(2)}; }

  Eigen::Matrix3d X() const {
    const Real &w = state_[3], &x = state_[4], &y = state_[5], &z = state_[6];
    const auto element = [](const Real& value) { return static_cast<double>(value); };
    Eigen::Matrix3d X;
    X << element(1 - 2 * (y * y + z * z)), element(2 * (x * y - w * z)),
        element(2 * (x * z + w * y)), element(2 * (x * y + w * z)),
        element(1 - 2 * (x * x + z * z)), element(2 * (y * z - w * x)),
        element(2 * (x * z - w * y)), element(2 * (y * z + w * x)),
        element(1 - 2 * (x * x + y * y));
    return X;
  }

 private:
  using State = std::array<Real, 7>;  ///< omega, then the unit quaternion, scalar first

  double as_double(std::size_t i) const { return static_cast<double>(state_[i]); }

  void expand() {
    series_[0] = state_;
    for (std::size_t n = 0; n < order; ++n) {
      State sum{};
      for (std::size_t i = 0; i <= n; ++i) {
        add_products(sum, series_[i], series_[n - i]);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        series_[n + 1][k] = euler_[k] * sum[k] / Real(n + 1);
      }
      for (std::size_t k = 3; k < 7; ++k) {
        series_[n + 1][k] = sum[k] / Real(2 * (n + 1));
      }
    }
  }

  /// Adds the terms of omega_j omega_k and of the quaternion product q (0, omega).
  static void add_products(State& sum, const State& a, const State& b) {
    sum[0] += a[1] * b[2];
    sum[1] += a[2] * b[0];
    sum[2] += a[0] * b[1];
    sum[3] -= a[4] * b[0] + a[5] * b[1] + a[6] * b[2];
    sum[4] += a[3] * b[0] + a[5] * b[2] - a[6] * b[1];
    sum[5] += a[3] * b[1] + a[6] * b[0] - a[4] * b[2];
    sum[6] += a[3] * b[2] + a[4] * b[1] - a[5] * b[0];
  }

  /// Returns the step at which the last two terms fall below round-off.
  Real reach() const {
    double rate = 0;
    for (const std::size_t n : {order - 1, order}) {
      double omega = 0, quaternion = 0, omega0 = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        omega = std::hypot(omega, static_cast<double>(series_[n][k]));
        omega0 = std::hypot(omega0, as_double(k));
      }
      for (std::size_t k = 3; k < 7; ++k) {
        quaternion = std::hypot(quaternion, static_cast<double>(series_[n][k]));
      }
      rate = std::max(rate, std::pow(omega / omega0 + quaternion, 1.0 / static_cast<double>(n)));
    }
    const double round_off = static_cast<double>(std::numeric_limits<Real>::epsilon()) / 4;
    return Real(std::pow(round_off, 1.0 / order) / rate);
  }

  std::array<Real, 3> euler_;
  State state_{};
  std::array<State, order + 1> series_{};
  Real t_ = 0;
};

}  // namespace twrench::motion
