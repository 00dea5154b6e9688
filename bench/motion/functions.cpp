// Times single calls of the hot functions of a motion.
#include <benchmark/benchmark.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/stepper.h>
#include <twrench/motion/taylor.h>
#include <twrench/motion/trajectory.h>

namespace twrench {
namespace {

/// Tumbling about its intermediate axis.
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
  motion::TaylorSeries series(body, std::get<motion::Taylor>(motion::find_method("taylor").scheme));
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
  motion::TaylorSeries series(body, std::get<motion::Taylor>(motion::find_method("taylor").scheme));
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

/// The cost of initialisation.
void exact_set_up(benchmark::State& state) {
  const motion::FreeBody body = tumbler();
  for (auto _ : state) benchmark::DoNotOptimize(motion::ExactMotion(body));
}
BENCHMARK(exact_set_up);

}  // namespace
}  // namespace twrench
