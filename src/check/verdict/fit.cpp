#include "check/verdict/fit.h"

#include <twrench/math/so3.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

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

/// The factors of the residuals, and how many numbers of the inertia are fitted. A factor is 0 if
/// the rows have no such residuals.
struct Weights {
  double rates;                      ///< s/rad
  double attitude;                   ///< 1/rad
  Eigen::Index inertia_numbers = 0;  ///< of its change that are fitted: the first 2 or all 5

  std::size_t numbers_per_row() const {
    return static_cast<std::size_t>(3 * ((rates > 0) + (attitude > 0)));
  }
};

/// The rotation vector from one attitude to another, in the axes of the first.
Vector3d turn_between(const Matrix3d& from, const Matrix3d& to) {
  const Matrix3d back = from.transpose();  // GCC does not inline the product of a transposed one
  return so3::log(back * to);
}

/// The residuals of rows as a function of the fitted parameters. Parameters: the change of omega in
/// units of |omega|; if there is an attitude, the rotation vector by which the frame turns; if the
/// inertia is open, its change.
class Residuals {
 public:
  Residuals(const Reference& from, std::span<const Row> rows, const Weights& weights,
            const std::atomic<bool>* stop = nullptr)
      : inputs_(3 + (weights.attitude > 0 ? 3 : 0) + weights.inertia_numbers),
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
    InertiaChange change = InertiaChange::Zero();
    change.head(weights_.inertia_numbers) = p.tail(weights_.inertia_numbers);
    const Matrix3d inertia = weights_.inertia_numbers > 0
                                 ? changed_inertia(from_.body.inertia(), change)
                                 : from_.body.inertia();
    Reference reference{{inertia, omega}, from_.start, from_.frame};
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
        const Matrix3d ought = at.frame * exact_.X(i);
        residuals.segment<3>(next) = weights_.attitude * turn_between(rows_[i].X, ought);
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
          inverse(weights.attitude, std::max(left.attitude, round_off)), weights.inertia_numbers};
}

/// Whether the rates count as much beside the attitudes, up to a factor of two.
bool are_alike(const Weights& a, const Weights& b) {
  const double one = a.rates * b.attitude, other = b.rates * a.attitude;
  return one <= 2 * other && other <= 2 * one;
}

/// The covariance of the fitted parameters: omega in units of |omega|, the frame in rad.
MatrixXd covariance_of(const Residuals& residuals) {
  const VectorXd left = residuals_of(residuals);
  MatrixXd jacobian(residuals.values(), residuals.inputs());
  residuals.differentiate(VectorXd::Zero(residuals.inputs()), jacobian);
  const auto freedom = std::max<Eigen::Index>(1, residuals.values() - residuals.inputs());
  return left.squaredNorm() / static_cast<double>(freedom) * inverse_of_squares(jacobian);
}

/// The fitted inertia; nothing if the rows do not determine the ratios of the moments.
std::optional<FittedInertia> inertia_of(const Reference& reference, const MatrixXd& covariance,
                                        Eigen::Index numbers) {
  if (!covariance.allFinite()) return std::nullopt;
  Eigen::Matrix<double, 5, 5> of_change = Eigen::Matrix<double, 5, 5>::Zero();
  of_change.topLeftCorner(numbers, numbers) = covariance.bottomRightCorner(numbers, numbers);
  const FittedInertia found = fitted_inertia(reference.body.inertia(), of_change);
  // Beyond this condition, rows that are exact to round-off look determined.
  const VectorXd variances = Eigen::SelfAdjointEigenSolver<MatrixXd>(covariance).eigenvalues();
  constexpr double worst = 1e10;
  if (!(variances.maxCoeff() < worst * variances.minCoeff())) return std::nullopt;
  constexpr double most = 0.2;  // relative
  const bool is_determined = found.moments[2] < 0.99 * most_ratio_of_moments &&
                             found.deviation.allFinite() &&
                             (found.deviation.array() < most * found.moments.array()).all();
  return is_determined ? std::optional(found) : std::nullopt;
}

Fit result(const std::string& name, const Reference& reference, std::span<const Row> rows,
           const Weights& weights) {
  const Residuals residuals(reference, rows, weights);
  const MatrixXd covariance = covariance_of(residuals);
  const RootMeanSquares left = root_mean_squares(residuals_of(residuals), weights);
  const double speed = reference.body.omega().norm();
  const bool is_determined =
      covariance.allFinite() && std::isfinite(left.rates + left.attitude) && std::isfinite(speed);
  if (weights.inertia_numbers == 0 && !is_determined) {
    throw CheckError(name, "its rows do not determine a state", CheckError::Reason::no_fit);
  }
  Fit fit{reference, {}, speed * speed * covariance.topLeftCorner<3, 3>(), {}, {}, {}, rows.size()};
  fit.omega_deviation = fit.omega_covariance.diagonal().cwiseSqrt();
  if (weights.inertia_numbers > 0)
    fit.inertia = inertia_of(reference, covariance, weights.inertia_numbers);
  if (weights.rates > 0) fit.rate_residual = left.rates;
  if (weights.attitude > 0) {
    fit.attitude_residual = left.attitude;
    fit.frame_deviation = covariance.diagonal().segment<3>(3).cwiseSqrt();
  }
  return fit;
}

/// Fits rows with the weights that the residuals themselves suggest, until these hardly change:
/// rates with noise must not spoil attitudes without any, which determine the motion far better.
Weights fit_with_weights(Reference& reference, std::span<const Row> rows, Weights weights,
                         const std::atomic<bool>* stop) {
  constexpr int most_repetitions = 6;
  const double speed = reference.body.omega().norm();
  const double most = std::max(weights.rates * speed, weights.attitude);
  weights.rates /= most;  // so that the search ends at the same relative change
  weights.attitude /= most;
  reference = improved(reference, rows, weights, stop);
  if (weights.inertia_numbers > 0) return weights;  // only rates are fitted, in any unit
  for (int i = 0; i < most_repetitions; ++i) {
    const RootMeanSquares left =
        root_mean_squares(residuals_of(Residuals(reference, rows, weights)), weights);
    const Weights before = std::exchange(weights, reweighted(weights, left, speed));
    reference = improved(reference, rows, weights, stop);
    if (are_alike(before, weights)) break;
  }
  return weights;
}

/// The root mean square of the residuals in units of |omega| and in rad.
double misfit_of(const Reference& reference, std::span<const Row> rows, const Weights& weights) {
  const RootMeanSquares left =
      root_mean_squares(residuals_of(Residuals(reference, rows, weights)), weights);
  return std::hypot(left.rates / reference.body.omega().norm(), left.attitude);
}

/// Fits the first `count` rows, then up to twice as many, until it has all. Where more rows than
/// the state predicts make the search end far from them, it takes fewer at a time.
Fit fitted_from(const std::string& name, Reference reference, std::span<const Row> rows,
                std::size_t count, Weights weights, const std::atomic<bool>* stop) {
  count = std::min(count, rows.size());
  weights = fit_with_weights(reference, rows.first(count), weights, stop);
  double more = 2;
  for (int retreats = 0; count < rows.size();) {
    const std::size_t next =
        std::min(rows.size(), static_cast<std::size_t>(std::ceil(more * double(count))));
    Reference farther = reference;
    const Weights after = fit_with_weights(farther, rows.first(next), weights, stop);
    constexpr double far = 1.5;
    constexpr int most_retreats = 8;
    if (retreats < most_retreats && misfit_of(farther, rows.first(next), after) >
                                        far * misfit_of(reference, rows.first(count), weights)) {
      more = std::sqrt(more);
      ++retreats;
      continue;
    }
    more = std::min(2.0, more * more);
    std::tie(reference, weights, count) = std::tuple(farther, after, next);
  }
  return result(name, reference, rows, weights);
}

}  // namespace

Fit fit(const std::string& name, const Matrix3d& inertia, std::span<const Row> rows,
        const Vector3d& omega, bool has_rates, bool has_attitude, const std::atomic<bool>* stop) {
  if (rows.size() < 2) {
    throw CheckError(name, "has only one row, but a fit needs at least two",
                     CheckError::Reason::one_row);
  }
  const double speed = omega.norm();
  const Reference reference{{inertia, omega}, rows.front().t, nearest_rotation(rows.front().X)};
  if (speed == 0)
    throw CheckError(name, "the body is at rest in it, so no motion can be fitted",
                     CheckError::Reason::at_rest);
  const Weights weights{has_rates ? 1 / speed : 0, has_attitude ? 1.0 : 0};
  return fitted_from(name, reference, rows, 16, weights, stop);
}

namespace {

CheckError undetermined_inertia(const std::string& name) {
  return {name,
          "its motion does not determine the ratios of the moments: it hardly differs from a "
          "steady spin or from its noise, or the principal axes are not those of the rates",
          CheckError::Reason::no_inertia};
}

constexpr std::size_t most_rows_of_inertia = 2048;

/// At most so many rows, spread evenly over the given ones, so that the fit of an inertia takes
/// little time even if it converges slowly, as for a motion that is not free.
std::vector<Row> spread_over(std::span<const Row> rows) {
  recording::ThinnedRows spread(most_rows_of_inertia);
  for (const Row& row : rows) spread.add(row);
  return spread.rows();
}

/// Fits the first numbers of the change of an inertia to the first rows, then to rows spread over
/// all.
Fit fit_with_inertia(const std::string& name, const Matrix3d& inertia, std::span<const Row> rows,
                     std::size_t count, Eigen::Index numbers, const std::atomic<bool>* stop) {
  const Vector3d omega = rows.front().omega;
  const Reference reference{{inertia, omega}, rows.front().t};
  const Weights weights{1 / omega.norm(), 0, numbers};
  const auto first = rows.first(std::min(rows.size(), most_rows_of_inertia));
  const Fit found = fitted_from(name, reference, first, count, weights, stop);
  if (first.size() == rows.size()) return found;
  const std::vector<Row> spread = spread_over(rows);
  const std::size_t fitted = first.size() * spread.size() / rows.size();
  return fitted_from(name, found.reference, spread, fitted, weights, stop);
}

/// The root mean square of the changes of the rates, component by component.
double change_of_rates_in(std::span<const Row> rows) {
  Vector3d sum = Vector3d::Zero();
  for (const Row& row : rows) sum += row.omega;
  const Vector3d mean = sum / static_cast<double>(rows.size());
  double squares = 0;
  for (const Row& row : rows) squares += (row.omega - mean).squaredNorm();
  return std::sqrt(squares / static_cast<double>(3 * rows.size()));
}

}  // namespace

FittedInertia fit_inertia(const std::string& name, std::span<const Row> rows,
                          const std::atomic<bool>* stop) {
  constexpr std::size_t least_rows = 16;
  double turned = 0;  // rad
  std::size_t count = 1;
  constexpr double enough = 8;
  for (; count < rows.size() && (turned < enough || count < least_rows); ++count)
    turned += rows[count].omega.norm() * (rows[count].t - rows[count - 1].t);
  if (count < least_rows || turned == 0) throw undetermined_inertia(name);
  if (rows.front().omega.norm() == 0) {
    throw CheckError(name, "its first row is at rest, but a body at rest stays so in free motion",
                     CheckError::Reason::no_inertia);
  }
  const auto [of_own_axes, of_any_axes] = estimated_inertia(rows);
  const Fit of_moments = fit_with_inertia(name, of_own_axes, rows, count, 2, stop);
  const Fit of_matrix = fit_with_inertia(name, of_any_axes, rows, count, 5, stop);
  // The fit with more numbers is preferred only if its residual is clearly smaller. If it does not
  // determine them and its residual is far smaller, the axes are others, but unknown.
  constexpr double clearly = 20, far = 0.5;
  const double less = std::exp(-clearly / static_cast<double>(6 * of_matrix.rows));
  const bool are_axes_others =
      !of_moments.inertia ||
      *of_matrix.rate_residual < (of_matrix.inertia ? less : far) * *of_moments.rate_residual;
  const Fit& best = are_axes_others ? of_matrix : of_moments;
  const bool is_steady = !(*best.rate_residual < less * change_of_rates_in(spread_over(rows)));
  if (is_steady || !best.inertia) throw undetermined_inertia(name);
  return *best.inertia;
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
