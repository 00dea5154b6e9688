#include <fmt/format.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>

#include "base/require.h"
#include "motion/exact_solution.h"

namespace twrench::motion {

bool ExactMotion::covers(const FreeBody& body) { return ExactSolution::covers(body); }

ExactMotion::ExactMotion(const FreeBody& body)
    : solution_(std::make_shared<const ExactSolution>(body)) {}

Sample ExactMotion::at(double t) const { return solution_->at(t); }

void ExactMotion::at(std::span<const double> times, std::span<double> X, std::span<double> omega,
                     unsigned threads) const {
  solution_->at(times, X, omega, threads);
}

std::vector<Sample> ExactMotion::at(std::span<const double> times, unsigned threads) const {
  return solution_->at(times, threads);
}

ExactMotion::Kind ExactMotion::kind() const { return solution_->kind(); }

std::optional<ExactMotion::Flips> ExactMotion::flips() const { return solution_->flips(); }

std::optional<double> ExactMotion::nutation_period() const { return solution_->nutation_period(); }

std::optional<ExactMotion::Phase> ExactMotion::phase() const { return solution_->phase(); }

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

Eigen::Matrix3d attitude_at(std::span<const double> X, std::size_t index) {
  const std::size_t count = X.size() / 9;
  if (index >= count) {
    throw OutOfRange("index", fmt::format("is {}, but there are {} attitudes", index, count),
                     {double(index), 0, double(count) - 1});
  }
  const double* x = &X[9 * index];
  Eigen::Matrix3d attitude;
  attitude << x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8];
  return attitude;
}

FreeBody exact_step(const FreeBody& body, double h) {
  const Sample end = ExactSolution(body).at(h);
  return body.with_start(end.omega, end.X);
}

}  // namespace twrench::motion
