#include <algorithm>
#include <cmath>

#include "motion/interior_series.h"

namespace twrench::motion {

/// Computes the coefficients of several series with the operations of expand(), so that numbers of
/// one kind fill a register and no operation waits for the one before it.
struct InteriorSeries::Together {
  using Number = double __attribute__((vector_size(lanes * sizeof(double))));
  using Vector = std::array<Number, 3>;
  using Coefficients = std::array<Vector, max_taylor_order + 1>;

  std::array<InteriorSeries, lanes>& series;
  const std::array<double, lanes>& longest;
  Vector momentum, rate;
  std::array<std::array<Number, 4>, max_taylor_order + 1> q;  // x, y, z, w
  std::array<double, lanes> power, before;
  std::array<bool, lanes> complete{};

  Together(std::array<InteriorSeries, lanes>& all, const std::array<State, lanes>& states,
           const std::array<double, lanes>& reaches)
      : series(all), longest(reaches) {
    power.fill(1);
    before.fill(1);
    for (std::size_t i = 0; i < lanes; ++i) {
      InteriorSeries& s = series[i];
      s.start_ = states[i];
      const Eigen::Vector3d m = s.start_.X.transpose() * s.body_.momentum() / s.momentum_unit_;
      const Eigen::Vector3d w = s.inverse_ * (m - s.body_.interior().wheel / s.momentum_unit_);
      for (std::size_t a = 0; a < 3; ++a) {
        momentum[a][i] = m[static_cast<Eigen::Index>(a)];
        rate[a][i] = w[static_cast<Eigen::Index>(a)];
      }
      s.q_[0] = {1, Eigen::Vector3d::Zero()};
      for (std::size_t a = 0; a < 4; ++a) q[0][a][i] = a == 3;
    }
  }

  /// Stores the coefficients of order k, and returns whether every series is complete.
  bool store(std::size_t k) {
    bool all = true;
    for (std::size_t i = 0; i < lanes; ++i) {
      if (complete[i]) continue;
      InteriorSeries& s = series[i];
      Quaternion& c = s.q_[k];
      c = {q[k][3][i], {q[k][0][i], q[k][1][i], q[k][2][i]}};
      s.last_order_ = k;
      power[i] *= std::abs(longest[i]) / s.time_unit_;
      const double contribution = power[i] * (std::abs(c.w) + c.v.lpNorm<1>());
      complete[i] = k == s.order_ || std::max(before[i], contribution) < negligible;
      before[i] = contribution;
      all = all && complete[i];
    }
    return all;
  }

  /// Multiplies as expand() does: the order of Eigen's sum depends on the processor.
  void set_rates() {
    for (std::size_t i = 0; i < lanes; ++i) {
      const Eigen::Vector3d w =
          series[i].inverse_ * Eigen::Vector3d(momentum[0][i], momentum[1][i], momentum[2][i]);
      for (std::size_t a = 0; a < 3; ++a) rate[a][i] = w[static_cast<Eigen::Index>(a)];
    }
  }

  [[gnu::always_inline]] static void add_cross(Vector& sum, const Vector& a, const Vector& b) {
    sum[0] += a[1] * b[2] - a[2] * b[1];
    sum[1] += a[2] * b[0] - a[0] * b[2];
    sum[2] += a[0] * b[1] - a[1] * b[0];
  }

  [[gnu::always_inline]] void expand() {
    const double loss = series[0].loss_;
    Coefficients m, w, omega;
    for (std::size_t k = 0;; ++k) {
      m[k] = momentum;
      w[k] = rate;
      Vector c{};
      for (std::size_t j = 0; j <= k; ++j) add_cross(c, m[j], w[k - j]);
      for (std::size_t a = 0; a < 3; ++a) omega[k][a] = rate[a] + loss * c[a];
      Vector change{};
      std::array<Number, 4> turn{};
      for (std::size_t j = 0; j <= k; ++j) {
        const Vector& o = omega[k - j];
        const std::array<Number, 4>& p = q[j];
        add_cross(change, m[j], o);
        turn[0] += p[3] * o[0] + p[1] * o[2] - p[2] * o[1];
        turn[1] += p[3] * o[1] + p[2] * o[0] - p[0] * o[2];
        turn[2] += p[3] * o[2] + p[0] * o[1] - p[1] * o[0];
        turn[3] += -p[2] * o[2] - p[0] * o[0] - p[1] * o[1];
      }
      const double next = static_cast<double>(k) + 1, half = 0.5 / next;
      for (std::size_t a = 0; a < 4; ++a) q[k + 1][a] = half * turn[a];
      if (store(k + 1)) return;
      for (std::size_t a = 0; a < 3; ++a) momentum[a] = change[a] / next;
      set_rates();
    }
  }

  // One function per register width. None may fuse a multiplication with an addition, so that the
  // bits are the same on every processor.
  static void expand_baseline(Together& together) { together.expand(); }
#ifdef __x86_64__
  [[gnu::target("avx2")]] static void expand_256(Together& together) { together.expand(); }
  [[gnu::target("avx512f,avx512dq,avx512vl")]] static void expand_512(Together& together) {
    together.expand();
  }
#endif

  using Expand = void (*)(Together&);
  static Expand widest() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) return expand_512;
    if (__builtin_cpu_supports("avx2")) return expand_256;
#endif
    return expand_baseline;
  }
};

void InteriorSeries::expand_together(std::array<InteriorSeries, lanes>& series,
                                     const std::array<State, lanes>& states,
                                     const std::array<double, lanes>& longest) {
  static const Together::Expand expand = Together::widest();
  Together together(series, states, longest);
  expand(together);
}

}  // namespace twrench::motion
