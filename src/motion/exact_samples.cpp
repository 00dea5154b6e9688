#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/require.h"
#include "math/elementary.h"
#include "math/elliptic_series.h"
#include "motion/exact_solution.h"

namespace twrench::motion {
namespace {

/// This many samples take about 100 us. For fewer, starting a thread does not pay.
constexpr std::size_t samples_per_part = 16384;

/// The direction of the body momentum, mu = m/G = (a, b, c), and the quaternion of Rot(e_a, psi) P,
/// eq. (E5), up to a factor.
struct Turn {
  double a, b, c;
  double w, x, y, z;
};

/// An attitude, row by row, and an angular velocity.
struct Place {
  double xx, xy, xz, yx, yy, yz, zx, zy, zz;
  double omega_x, omega_y, omega_z;
};

void require_size(const char* quantity, std::size_t size, std::size_t samples, std::size_t each) {
  if (size == samples * each) return;
  throw InvalidArgument(quantity, fmt::format("has {} numbers, but {} samples take {}", size,
                                              samples, samples * each));
}

}  // namespace

/// Evaluates samples. A single sample and those of a block are computed by the same operations. The
/// compiler may vectorise them without changing a bit.
struct ExactSolution::Samples {
  /// Consecutive samples as a structure of arrays, so that numbers of one kind fill a register. Few
  /// enough for the nearest cache.
  struct Block {
    static constexpr std::size_t capacity = 64;
    std::size_t size;
    double t[capacity];
    double X[9][capacity];  ///< row-major
    double omega[3][capacity];
  };

  [[gnu::always_inline]] static Turn turn(const Orbit& orbit, const elliptic::Jacobi::Values& v,
                                          double t) {
    const double a = orbit.amplitude[0] * v.dn, b = orbit.amplitude[1] * v.sn,
                 c = orbit.amplitude[2] * v.cn;
    // re and im are a multiple of exp(i psi/2), eq. (E7), which multiplies P, eq. (E5).
    const auto [sin, cos] = elementary::sincos_quarter_turns(orbit.quarter_turns * t +
                                                             v.angle * (2 * std::numbers::inv_pi));
    const double re = cos * v.re - sin * v.im, im = sin * v.re + cos * v.im;
    return {a, b, c, re * (1 + a), im * (1 + a), re * c + im * b, im * c - re * b};
  }

  [[gnu::always_inline]] static Place place(const Orbit& orbit, const elliptic::Jacobi::Values& v,
                                            double t) {
    const Turn at = turn(orbit, v, t);
    const auto q = [&](int i) __attribute__((always_inline)) {
      const auto& Q = orbit.attitude_from_turn;
      return (Q(i, 0) * at.w + Q(i, 1) * at.x) + (Q(i, 2) * at.y + Q(i, 3) * at.z);
    };
    const auto omega = [&](int i) __attribute__((always_inline)) {
      const auto& W = orbit.omega_from_mu;
      return W(i, 0) * at.a + W(i, 1) * at.b + W(i, 2) * at.c;
    };
    const double w = q(0), x = q(1), y = q(2), z = q(3);
    const double xx = x * x, yy = y * y, zz = z * z, f = 2 / ((w * w + xx) + (yy + zz));
    const double wx = w * x, wy = w * y, wz = w * z, xy = x * y, yz = y * z, zx = z * x;
    return {1 - f * (yy + zz), f * (xy - wz),     f * (zx + wy),      //
            f * (xy + wz),     1 - f * (xx + zz), f * (yz - wx),      //
            f * (zx - wy),     f * (yz + wx),     1 - f * (xx + yy),  //
            omega(0),          omega(1),          omega(2)};
  }

  template <class Series>
  [[gnu::always_inline]] static void fill(const Orbit& constants, Block& block,
                                          const Series& series) {
    const Orbit orbit = constants;  // a copy, which cannot alias the block
    for (std::size_t i = 0; i < block.size; ++i) {
      const double t = block.t[i];
      const Place p = place(orbit, series(orbit.jacobi, orbit.rate * t + orbit.phase), t);
      block.X[0][i] = p.xx, block.X[1][i] = p.xy, block.X[2][i] = p.xz;
      block.X[3][i] = p.yx, block.X[4][i] = p.yy, block.X[5][i] = p.yz;
      block.X[6][i] = p.zx, block.X[7][i] = p.zy, block.X[8][i] = p.zz;
      block.omega[0][i] = p.omega_x, block.omega[1][i] = p.omega_y, block.omega[2][i] = p.omega_z;
    }
  }

  [[gnu::always_inline]] static void fill(const Orbit& orbit, Block& block) {
    using elliptic::Jacobi, elliptic::JacobiSeries;
    if (JacobiSeries::is_hyperbolic(orbit.jacobi)) {
      fill(
          orbit, block, [](const Jacobi& j, double u) __attribute__((always_inline)) {
            return JacobiSeries::hyperbolic(j, u);
          });
    } else {
      fill(
          orbit, block, [](const Jacobi& j, double u) __attribute__((always_inline)) {
            return JacobiSeries::circular(j, u);
          });
    }
  }

  // One function per register width. None may fuse a multiplication with an addition, so that the
  // bits are the same on every processor.
  static void fill_baseline(const Orbit& orbit, Block& block) { fill(orbit, block); }
#ifdef __x86_64__
  [[gnu::target("avx2")]] static void fill_256(const Orbit& orbit, Block& block) {
    fill(orbit, block);
  }
  [[gnu::target("avx512f,avx512dq,avx512vl")]] static void fill_512(const Orbit& orbit,
                                                                    Block& block) {
    fill(orbit, block);
  }
#endif

  static void set(Block& block, std::size_t i, const Sample& sample) {
    for (int k = 0; k < 9; ++k) block.X[k][i] = sample.X(k / 3, k % 3);
    for (int k = 0; k < 3; ++k) block.omega[k][i] = sample.omega[k];
  }

  using Fill = void (*)(const Orbit&, Block&);
  static Fill widest_fill() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) return fill_512;
    if (__builtin_cpu_supports("avx2")) return fill_256;
#endif
    return fill_baseline;
  }
};

so3::Quaternion ExactSolution::turn_at_start(const Orbit& orbit) {
  const Turn start = Samples::turn(orbit, orbit.jacobi.at(orbit.phase), 0);
  return {start.w, start.x, start.y, start.z};
}

Sample ExactSolution::at(double t) const {
  require_finite("t", t);
  if (t == 0) return {t, start_.X, start_.omega};
  const Place p = Samples::place(orbit_, orbit_.jacobi.at(orbit_.rate * t + orbit_.phase), t);
  Sample sample{t, {}, {p.omega_x, p.omega_y, p.omega_z}};
  sample.X << p.xx, p.xy, p.xz, p.yx, p.yy, p.yz, p.zx, p.zy, p.zz;
  return sample;
}

/// Calls `write(first, block)` for each block; `first` is the index of its first sample.
template <class Write>
void ExactSolution::for_each_block(std::span<const double> times, unsigned threads,
                                   const Write& write) const {
  static const Samples::Fill fill = Samples::widest_fill();
  for_each_part(times.size(), samples_per_part, threads, [&](std::size_t begin, std::size_t end) {
    Samples::Block block;
    for (std::size_t i = begin; i < end; i += block.size) {
      block.size = std::min(Samples::Block::capacity, end - i);
      std::ranges::copy(times.subspan(i, block.size), block.t);
      fill(orbit_, block);
      for (std::size_t k = 0; k < block.size; ++k) {
        if (block.t[k] == 0) Samples::set(block, k, start_);
      }
      write(i, block);
    }
  });
}

void ExactSolution::at(std::span<const double> times, std::span<double> X, std::span<double> omega,
                       unsigned threads) const {
  require_finite("times", times);
  if (!X.empty()) require_size("X", X.size(), times.size(), 9);
  if (!omega.empty()) require_size("omega", omega.size(), times.size(), 3);
  if (X.empty() && omega.empty()) return;
  if (omega.empty()) {
    for_each_block(times, threads, [&](std::size_t first, const Samples::Block& block) {
      double* attitude = &X[9 * first];
      for (std::size_t i = 0; i < block.size; ++i) {
        for (const auto& row : block.X) *attitude++ = row[i];
      }
    });
  } else if (X.empty()) {
    for_each_block(times, threads, [&](std::size_t first, const Samples::Block& block) {
      double* velocity = &omega[3 * first];
      for (std::size_t i = 0; i < block.size; ++i) {
        for (const auto& row : block.omega) *velocity++ = row[i];
      }
    });
  } else {
    for_each_block(times, threads, [&](std::size_t first, const Samples::Block& block) {
      double *attitude = &X[9 * first], *velocity = &omega[3 * first];
      for (std::size_t i = 0; i < block.size; ++i) {
        for (const auto& row : block.X) *attitude++ = row[i];
        for (const auto& row : block.omega) *velocity++ = row[i];
      }
    });
  }
}

std::vector<Sample> ExactSolution::at(std::span<const double> times, unsigned threads) const {
  require_finite("times", times);
  std::vector<Sample> samples(times.size());
  for_each_block(times, threads, [&](std::size_t first, const Samples::Block& block) {
    for (std::size_t i = 0; i < block.size; ++i) {
      Sample& sample = samples[first + i];
      sample.t = block.t[i];
      for (int k = 0; k < 9; ++k) sample.X(k / 3, k % 3) = block.X[k][i];
      for (int k = 0; k < 3; ++k) sample.omega[k] = block.omega[k][i];
    }
  });
  return samples;
}

}  // namespace twrench::motion
