#include "check/verdict/fit.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "check/verdict/error.h"
#include "check/verdict/exact_rows.h"
#include "check/verdict/frame.h"
#include "check/verdict/least_squares.h"
#include "check/verdict/stop.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The factors of the residuals; 0 if the rows have none of that kind.
struct Weights {
  double rates;     ///< s/rad
  double attitude;  ///< 1/rad

  std::size_t numbers_per_row() const {
    return static_cast<std::size_t>(3 * ((rates > 0) + (attitude > 0)));
  }
};

/// The residuals of rows as a function of the fitted parameters. Parameters: the change of omega in
/// units of |omega|; if there is an attitude, the rotation vector by which the frame turns.
class Residuals {
 public:
  Residuals(const Reference& from, std::span<const Row> rows, const Weights& weights,
            const std::atomic<bool>* stop = nullptr)
      : inputs_(3 + (weights.attitude > 0 ? 3 : 0)),
        from_(from),
        rows_(rows),
        weights_(weights),
        stop_(stop),
        speed_(from.body.omega().norm()) {}

  Eigen::Index inputs() const { return inputs_; }
  Eigen::Index values() const {
    return static_cast<Eigen::Index>(rows_.size() * weights_.numbers_per_row());
  }

  Reference reference(const VectorXd& p) const {
    const Vector3d omega = from_.body.omega() + speed_ * p.head<3>();
    Reference reference{{from_.body.inertia(), omega}, from_.start, from_.frame};
    if (weights_.attitude > 0) reference.frame = so3::exp(p.segment<3>(3)) * from_.frame;
    return reference;
  }

  void operator()(const VectorXd& p, VectorXd& residuals) const {
    throw_if_stopped(stop_);
    const Reference at = reference(p);
    exact_.evaluate(motion::ExactMotion(at.body), at.start, rows_);
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (weights_.rates > 0) {
        residuals.segment<3>(next) = weights_.rates * (exact_.omega(i) - rows_[i].omega);
        next += 3;
      }
      if (weights_.attitude > 0) {
        const Matrix3d apart = rows_[i].X.transpose() * at.frame * exact_.X(i);
        residuals.segment<3>(next) = weights_.attitude * so3::log(apart);
        next += 3;
      }
    }
  }

  /// Central differences.
  void differentiate(const VectorXd& p, MatrixXd& jacobian) const {
    constexpr double step = 1e-6;
    VectorXd ahead(values()), behind(values());
    for (Eigen::Index i = 0; i < inputs(); ++i) {
      (*this)(p + step * VectorXd::Unit(inputs(), i), ahead);
      (*this)(p - step * VectorXd::Unit(inputs(), i), behind);
      jacobian.col(i) = (ahead - behind) / (2 * step);
    }
  }

 private:
  Eigen::Index inputs_;
  Reference from_;
  std::span<const Row> rows_;
  Weights weights_;
  const std::atomic<bool>* stop_;
  double speed_;
  mutable ExactRows exact_;
};

/// Returns the reference that fits the rows best; the search starts at `from`.
Reference improved(const Reference& from, std::span<const Row> rows, const Weights& weights,
                   const std::atomic<bool>* stop) {
  const Residuals residuals(from, rows, weights, stop);
  return residuals.reference(minimized(
      {residuals.inputs(), residuals.values(),
       [&](const VectorXd& p, VectorXd& values) { residuals(p, values); },
       [&](const VectorXd& p, MatrixXd& jacobian) { residuals.differentiate(p, jacobian); }}));
}

/// Root mean squares of the components of the residuals, in rad/s and rad.
struct RootMeanSquares {
  double rates = 0, attitude = 0;
};

RootMeanSquares root_mean_squares(const VectorXd& residuals, const Weights& weights) {
  const auto width = static_cast<Eigen::Index>(weights.numbers_per_row());
  const double count = static_cast<double>(3 * (residuals.size() / width));
  RootMeanSquares sums;
  for (Eigen::Index i = 0; i < residuals.size(); i += width) {
    if (weights.rates > 0) sums.rates += residuals.segment<3>(i).squaredNorm();
    if (weights.attitude > 0) sums.attitude += residuals.segment<3>(i + width - 3).squaredNorm();
  }
  const auto root = [count](double sum, double weight) {
    return weight > 0 ? std::sqrt(sum / count) / weight : 0;
  };
  return {root(sums.rates, weights.rates), root(sums.attitude, weights.attitude)};
}

VectorXd residuals_of(const Residuals& residuals) {
  VectorXd values(residuals.values());
  residuals(VectorXd::Zero(residuals.inputs()), values);
  return values;
}

/// Weights each kind of residual by the inverse of what the fit left of it, at least round-off.
Weights reweighted(const Weights& weights, const RootMeanSquares& left, double speed) {
  constexpr double round_off = 1e-15;
  const auto inverse = [](double weight, double size) { return weight > 0 ? 1 / size : 0; };
  return {inverse(weights.rates, std::max(left.rates, round_off * speed)),
          inverse(weights.attitude, std::max(left.attitude, round_off))};
}

/// The covariance of the fitted parameters: omega in units of |omega|, the frame in rad.
MatrixXd covariance_of(const Residuals& residuals) {
  const VectorXd left = residuals_of(residuals);
  MatrixXd jacobian(residuals.values(), residuals.inputs());
  residuals.differentiate(VectorXd::Zero(residuals.inputs()), jacobian);
  const auto freedom = std::max<Eigen::Index>(1, residuals.values() - residuals.inputs());
  return left.squaredNorm() / static_cast<double>(freedom) * inverse_of_squares(jacobian);
}

Fit result(const std::string& name, const Reference& reference, std::span<const Row> rows,
           const Weights& weights) {
  const Residuals residuals(reference, rows, weights);
  const MatrixXd covariance = covariance_of(residuals);
  const RootMeanSquares left = root_mean_squares(residuals_of(residuals), weights);
  const double speed = reference.body.omega().norm();
  if (!covariance.allFinite() || !std::isfinite(left.rates + left.attitude) ||
      !std::isfinite(speed)) {
    throw CheckError(name, "its rows do not determine a state", CheckError::Reason::no_fit);
  }
  Fit fit{reference, {}, speed * speed * covariance.topLeftCorner<3, 3>(), {}, {}, {}, rows.size()};
  fit.omega_deviation = fit.omega_covariance.diagonal().cwiseSqrt();
  if (weights.rates > 0) fit.rate_residual = left.rates;
  if (weights.attitude > 0) {
    fit.attitude_residual = left.attitude;
    fit.frame_deviation = covariance.diagonal().tail<3>().cwiseSqrt();
  }
  return fit;
}

}  // namespace

Fit fit(const std::string& name, const Matrix3d& inertia, std::span<const Row> rows,
        const Vector3d& omega, bool has_rates, bool has_attitude, const std::atomic<bool>* stop) {
  if (rows.size() < 2) {
    throw CheckError(name, "has only one row, but a fit needs at least two",
                     CheckError::Reason::one_row);
  }
  const double speed = omega.norm();
  Reference reference{{inertia, omega}, rows.front().t, nearest_rotation(rows.front().X)};
  if (speed == 0)
    throw CheckError(name, "the body is at rest in it, so no motion can be fitted",
                     CheckError::Reason::at_rest);
  Weights weights{has_rates ? 1 / speed : 0, has_attitude ? 1.0 : 0};
  for (std::size_t count = 16; count < rows.size(); count *= 2) {
    reference = improved(reference, rows.first(count), weights, stop);
  }
  reference = improved(reference, rows, weights, stop);
  // Once more, with the weights that the residuals themselves suggest.
  const RootMeanSquares left =
      root_mean_squares(residuals_of(Residuals(reference, rows, weights)), weights);
  weights = reweighted(weights, left, speed);
  return result(name, improved(reference, rows, weights, stop), rows, weights);
}

Vector3d omega_between(const Matrix3d& inertia, const Row& first, const Row& second) {
  const double step = second.t - first.t;
  const Matrix3d turn = first.X.transpose() * second.X;
  Vector3d omega = so3::log(turn) / step;
  constexpr int most_iterations = 50;  // the less the body turns, the more each gains
  for (int i = 0; i < most_iterations && omega.norm() > 0; ++i) {
    const Matrix3d predicted = motion::ExactMotion({inertia, omega}).at(step).X;
    const Vector3d correction = so3::log(predicted.transpose() * turn) / step;
    omega += correction;
    constexpr double round_off = 1e-14;
    if (correction.norm() < round_off * omega.norm()) break;
  }
  return omega;
}

}  // namespace twrench::check
