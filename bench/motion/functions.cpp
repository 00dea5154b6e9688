// Times single calls of the hot functions of a motion.
#include <benchmark/benchmark.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact_many.h>
#include <twrench/motion/stepper.h>
#include <twrench/motion/trajectory.h>

#include <array>
#include <cmath>
#include <vector>

#include "motion/taylor.h"

namespace twrench {
namespace {

/// A body that tumbles about its intermediate axis.
motion::FreeBody tumbler() {
  return motion::FreeBody(Eigen::Vector3d(1, 2, 3).asDiagonal(), {0.01, 1, 0.02});
}

void exponential(benchmark::State& state) {
  Eigen::Vector3d u(0.01, -0.02, 0.03);
  for (auto _ : state) {
    benchmark::DoNotOptimize(u);
    benchmark::DoNotOptimize(so3::exp(u));
  }
}
BENCHMARK(exponential);

void step(benchmark::State& state, const char* name) {
  const motion::FreeBody body = tumbler();
  const motion::Method& method = motion::find_method(name);
  Eigen::Matrix3d X = Eigen::Matrix3d::Identity();
  for (auto _ : state) X = motion::take_step(body, method, X, 0.01).X;
  benchmark::DoNotOptimize(X);
}
BENCHMARK_CAPTURE(step, rk4, "rk4");
BENCHMARK_CAPTURE(step, rkmk4, "rkmk4");
BENCHMARK_CAPTURE(step, rkmk45, "rkmk45");

/// A step as a trajectory takes it.
void taylor_step(benchmark::State& state) {
  const motion::FreeBody body = tumbler();
  motion::TaylorSeries series(body,
                              std::get<motion::Taylor>(motion::find_method("taylor").scheme->kind));
  motion::TaylorSeries::State at = series.state_of(Eigen::Matrix3d::Identity(), body.momentum());
  for (auto _ : state) {
    series.expand(at);
    at = series.at(series.max_step(1e-10));
  }
  benchmark::DoNotOptimize(at);
}
BENCHMARK(taylor_step);

void taylor_sample(benchmark::State& state) {
  const motion::FreeBody body = tumbler();
  motion::TaylorSeries series(body,
                              std::get<motion::Taylor>(motion::find_method("taylor").scheme->kind));
  series.expand(series.state_of(Eigen::Matrix3d::Identity(), body.momentum()));
  double t = 0;
  for (auto _ : state) {
    t = t < 1 ? t + 1e-3 : 0;
    benchmark::DoNotOptimize(series.sample(t, series.at(t)));
  }
}
BENCHMARK(taylor_sample);

void exact_sample(benchmark::State& state) {
  const motion::ExactMotion motion(tumbler());
  double t = 0;
  for (auto _ : state) benchmark::DoNotOptimize(motion.at(t += 0.01));
}
BENCHMARK(exact_sample);

/// CPU time per item if an iteration processes `count` items.
benchmark::Counter each(double count) {
  return {count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

/// Near the separatrix and far from it, where different series apply.
const std::array<Eigen::Vector3d, 2> velocities{Eigen::Vector3d(0.01, 1, 0.02),
                                                Eigen::Vector3d(1, 0.5, 0.2)};

/// Many times for one body, on one thread.
void exact_samples(benchmark::State& state, const Eigen::Vector3d& omega) {
  const motion::ExactMotion motion(motion::FreeBody(Eigen::Vector3d(1, 2, 3).asDiagonal(), omega));
  std::vector<double> times(4096), X(9 * times.size()), velocity(3 * times.size());
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = 0.01 * static_cast<double>(i);
  for (auto _ : state) {
    motion.at(times, X, velocity, 1);
    benchmark::ClobberMemory();
  }
  state.counters["sample"] = each(static_cast<double>(times.size()));
}
BENCHMARK_CAPTURE(exact_samples, hyperbolic, velocities[0]);
BENCHMARK_CAPTURE(exact_samples, circular, velocities[1]);

/// Initial velocities all over the ellipsoid of a given momentum, as for a map of the first flips.
std::vector<double> starts(std::size_t count) {
  std::vector<double> omega;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(count) - 1;
    const double r = std::sqrt(1 - z * z), phi = 2.4 * static_cast<double>(i);
    for (const double w : {r * std::cos(phi), r * std::sin(phi) / 2, z / 3}) omega.push_back(w);
  }
  return omega;
}

/// As many times per body as the argument gives, on one thread.
void exact_many(benchmark::State& state) {
  const std::vector<double> inertia{1, 2, 3}, omega = starts(100);
  std::vector<double> times(static_cast<std::size_t>(state.range()));
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = 0.1 * static_cast<double>(i);
  const std::size_t samples = times.size() * omega.size() / 3;
  std::vector<double> X(9 * samples), velocity(3 * samples);
  for (auto _ : state) {
    motion::exact_many({inertia, omega}, times, {X, velocity}, 1);
    benchmark::ClobberMemory();
  }
  state.counters["sample"] = each(static_cast<double>(samples));
}
BENCHMARK(exact_many)->Arg(1)->Arg(100)->Arg(1000);

void first_flip(benchmark::State& state) {
  const std::vector<double> inertia{1, 2, 3}, omega = starts(10'000);
  std::vector<double> first(omega.size() / 3);
  for (auto _ : state) {
    motion::first_flip_times({inertia, omega}, first, 1);
    benchmark::ClobberMemory();
  }
  state.counters["body"] = each(static_cast<double>(first.size()));
}
BENCHMARK(first_flip);

/// A map of a million first flips on all processors, measured in real time.
void flip_map(benchmark::State& state) {
  const std::vector<double> inertia{1, 2, 3}, omega = starts(1'000'000);
  std::vector<double> first(omega.size() / 3);
  for (auto _ : state) {
    motion::first_flip_times({inertia, omega}, first);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(flip_map)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The cost of initialisation.
void exact_set_up(benchmark::State& state) {
  const motion::FreeBody body = tumbler();
  for (auto _ : state) benchmark::DoNotOptimize(motion::ExactMotion(body));
}
BENCHMARK(exact_set_up);

/// A step of a simulation, whose body is pushed between steps.
void exact_restart(benchmark::State& state) {
  motion::FreeBody body = tumbler();
  for (auto _ : state) body = motion::exact_step(body, 0.01);
  benchmark::DoNotOptimize(body);
}
BENCHMARK(exact_restart);

}  // namespace
}  // namespace twrench
