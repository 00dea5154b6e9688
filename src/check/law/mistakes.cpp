#include "check/law/mistakes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "check/law/candidates.h"
#include "check/verdict/least_squares.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Pairs of rows, spread over all rows, between which the body turns by about the same angle.
struct Pairs {
  std::vector<std::pair<State, State>> states;
  std::vector<double> times;  ///< between the rows of each pair, s
  RowScales scales = {};
  double law_step = 0;  ///< of advanced(), rad
};

/// Few pairs and large steps show which laws are worth a precise fit.
struct Effort {
  std::size_t pairs;
  double law_step;  ///< rad
};
constexpr Effort rough{32, 0.1}, precise{192, 0.02};

/// The angle within which numbers differ clearly from what a wrong law predicts, rad: more if they
/// are noisy.
double angle_of_pairs(double noise) {
  constexpr double least = 0.5, most = 6, noise_at_least = 5e-4;
  return std::clamp(least * noise / noise_at_least, least, most);
}

/// The root mean square of the changes of the rates from row to row that are not noise, relative to
/// the largest |w|.
double change_of_rates(std::span<const Row> rows, double noise, double speed) {
  double sum = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    sum += (rows[i].omega - rows[i - 1].omega).squaredNorm();
  const double mean = sum / (speed * speed * static_cast<double>(rows.size() - 1));
  constexpr double of_noise = 6;  // three components of two rows
  return std::sqrt(std::max(0.0, mean - of_noise * noise * noise));
}

Pairs pairs_of(std::span<const Row> rows, double noise, const Effort& effort) {
  Pairs pairs;
  RowScales& scales = pairs.scales;
  for (const Row& row : rows.subspan(1))
    scales.later_speed = std::max(scales.later_speed, row.omega.norm());
  scales.speed = std::max(scales.later_speed, rows.front().omega.norm());
  scales.step = (rows.back().t - rows.front().t) / static_cast<double>(rows.size() - 1);
  // A wrong law can change the rates faster than the body turns. Pairs many such changes apart fit
  // slower laws by chance, and amplify the noise of their first row.
  const double turn = scales.speed * scales.step;
  const double change = std::max(turn, change_of_rates(rows, noise, scales.speed));
  pairs.law_step = effort.law_step * turn / change;
  const double apart = angle_of_pairs(noise) / change;
  const auto farthest = static_cast<double>(std::max<std::size_t>(1, rows.size() / 4));
  const auto stride = static_cast<std::size_t>(std::clamp(apart, 1.0, farthest));
  const std::size_t starts = rows.size() - stride, count = std::min(effort.pairs, starts);
  for (std::size_t k = 0; k < count; ++k) {
    // If all were equally far apart, rates that turn once more between them, or once less, would
    // fit as well.
    constexpr std::size_t lengths = 4;
    const std::size_t shorter = k % lengths * stride / (2 * lengths);
    const std::size_t first = k * starts / count;
    const Row &from = rows[first], &to = rows[first + stride - shorter];
    pairs.states.emplace_back(state_of(from), state_of(to));
    pairs.times.push_back(to.t - from.t);
  }
  return pairs;
}

/// The difference between a law and the second row of a pair.
using Residual = Vector3d (*)(const Law& law, const State& from, const State& to, double time,
                              double law_step);

Vector3d rates_residual(const Law& law, const State& from, const State& to, double time,
                        double law_step) {
  if (law.kinematics != Kinematics::space_rates)
    return advanced(law, from, time, law_step).omega - to.omega;
  const State end = advanced(law, {from.X * from.omega, from.X}, time, law_step);
  return end.X.conjugate() * end.omega - to.omega;
}

Vector3d attitude_residual(const Law& law, const State& from, const State& to, double time,
                           double law_step) {
  const auto residual = [&](const Law& one) {
    return rotation_vector(advanced(one, from, time, law_step).X.conjugate() * to.X);
  };
  if (law.kinematics != Kinematics::integrated_angles) return residual(law);
  Law other = law;
  other.is_upside_down = true;
  const Vector3d a = residual(law), b = residual(other);
  return a.norm() < b.norm() ? a : b;
}

/// The change in a pair of rows.
Vector3d rates_change(const State& from, const State& to) { return to.omega - from.omega; }
Vector3d attitude_change(const State& from, const State& to) {
  return rotation_vector(from.X.conjugate() * to.X);
}

/// The quantity of a row that is compared: the rates, or the attitude.
struct Aspect {
  Residual residual;
  Vector3d (*change)(const State& from, const State& to);
  double unit;       ///< of the residuals
  double own_noise;  ///< of a residual apart from the rates of the first row, in this unit
};

Aspect rates_of(const Pairs& pairs, const RelativeNoise& noise) {
  return {rates_residual, rates_change, pairs.scales.speed, noise.rates};
}

Aspect attitude_of(const RelativeNoise& noise) {
  return {attitude_residual, attitude_change, 1, std::numbers::sqrt2 * noise.attitude};
}

/// How well laws explain pairs of rows.
class Comparer {
 public:
  Comparer(const Pairs& pairs, const Aspect& aspect, const Law& right, double noise_of_rates)
      : pairs_(pairs), aspect_(aspect), right_(right), noise_of_rates_(noise_of_rates) {
    for (std::size_t i = 0; i < pairs.states.size(); ++i) {
      const auto& [from, to] = pairs.states[i];
      const State expected = advanced(right, from, pairs.times[i], pairs.law_step);
      const double found = aspect.change(from, to).squaredNorm();
      changes_ += std::max(found, aspect.change(from, expected).squaredNorm());
    }
    miss_of_right_ = miss(right);
  }

  /// The miss of the right law.
  double miss_of_right() const { return miss_of_right_; }

  /// Root mean square of what the law misses, relative to what changes.
  double miss(const Law& law) const {
    const double ratio = residuals(law).squaredNorm() * aspect_.unit * aspect_.unit / changes_;
    return std::isfinite(ratio) ? std::sqrt(ratio) : std::numeric_limits<double>::infinity();
  }

  /// The number of residuals.
  double count() const { return static_cast<double>(3 * pairs_.states.size()); }

  /// The miss that the noise of the rows lets a right law have, to first order: that of the second
  /// rows, and that of the first rows as the law amplifies it.
  double miss_of_noise(const Law& law) const {
    const double own = aspect_.own_noise * aspect_.own_noise * count();
    const double amplified = noise_of_rates_ * noise_of_rates_ * amplification(law);
    return aspect_.unit * std::sqrt((own + amplified) / changes_);
  }

  Explanation fitted(const Candidate& candidate) const;

 private:
  VectorXd residuals(const Law& law) const {
    VectorXd values(static_cast<Index>(3 * pairs_.states.size()));
    for (std::size_t i = 0; i < pairs_.states.size(); ++i) {
      const auto& [from, to] = pairs_.states[i];
      values.segment<3>(static_cast<Index>(3 * i)) =
          aspect_.residual(law, from, to, pairs_.times[i], pairs_.law_step) / aspect_.unit;
    }
    return values;
  }

  /// The sum of the squared derivatives of the residuals by the rates of the first rows, in units
  /// of the largest |w|.
  double amplification(const Law& law) const {
    constexpr double step = 1e-6;
    double sum = 0;
    for (std::size_t i = 0; i < pairs_.states.size(); ++i) {
      const auto& [from, to] = pairs_.states[i];
      const auto residual = [&](const State& start) {
        return Vector3d(aspect_.residual(law, start, to, pairs_.times[i], pairs_.law_step) /
                        aspect_.unit);
      };
      const Vector3d before = residual(from);
      for (int k = 0; k < 3; ++k) {
        State start = from;
        start.omega[k] += step * pairs_.scales.speed;
        sum += ((residual(start) - before) / step).squaredNorm();
      }
    }
    return sum;
  }

  const Pairs& pairs_;
  Aspect aspect_;
  const Law& right_;
  double noise_of_rates_, changes_ = 0, miss_of_right_ = 0;
};

Explanation Comparer::fitted(const Candidate& candidate) const {
  const Index count = candidate.start.size();
  // Far from the start, angles of more than half a turn are ambiguous.
  VectorXd start = candidate.start;
  for (const double usual : candidate.usual) {
    VectorXd other = start;
    other[0] = usual;
    if (miss(candidate.law(right_, other)) < miss(candidate.law(right_, start))) start = other;
  }
  const auto law_at = [&](const VectorXd& p) {
    return candidate.law(right_, start + candidate.scale.cwiseProduct(p));
  };
  const auto differentiate = [&](const VectorXd& p, MatrixXd& jacobian) {
    constexpr double step = 1e-5;
    for (Index k = 0; k < count; ++k) {
      const VectorXd change = step * VectorXd::Unit(count, k);
      jacobian.col(k) =
          (residuals(law_at(p + change)) - residuals(law_at(p - change))) / (2 * step);
    }
  };
  const auto rows = static_cast<Index>(3 * pairs_.states.size());
  VectorXd p = VectorXd::Zero(count), deviation = VectorXd::Zero(count);
  if (count > 0) {
    p = minimized({count, rows,
                   [&](const VectorXd& at, VectorXd& values) { values = residuals(law_at(at)); },
                   differentiate});
    MatrixXd jacobian(rows, count);
    differentiate(p, jacobian);
    const double variance = residuals(law_at(p)).squaredNorm() / static_cast<double>(rows - count);
    deviation = (variance * inverse_of_squares(jacobian).diagonal()).cwiseSqrt();
  }
  Explanation found{candidate.mistake,
                    law_at(p),
                    start + candidate.scale.cwiseProduct(p),
                    candidate.scale.cwiseProduct(deviation),
                    static_cast<int>(count),
                    0};
  // A number close to a usual one is taken for it.
  for (const double usual : candidate.usual) {
    constexpr double deviations = 4, close = 2e-3;
    const double near = std::max(deviations * found.deviation[0], close * candidate.scale[0]);
    if (!(std::abs(found.value[0] - usual) < near)) continue;
    found.value[0] = usual;
    found.free_numbers -= 1;
    found.law = candidate.law(right_, found.value);
  }
  found.miss = miss(found.law);
  return found;
}

/// How many times larger the miss of a right law may be than its noise, whose size is estimated.
constexpr double about_noise = 1.5;

/// The explanations that fit about equally well, with the fewest free numbers. None if even the
/// best explains too little of what the law as read misses: errors of methods look like small
/// changes of a law, but what a law leaves of them is not far smaller, nor noise.
std::vector<Explanation> best(std::vector<Explanation> all, const Comparer& precisely) {
  constexpr double far_better = 0.01, clearly_better = 0.5;
  const Explanation nearest = std::ranges::min(all, {}, &Explanation::miss);
  const double least = nearest.miss;
  const double of_noise = precisely.miss_of_noise(nearest.law);
  const bool is_noise = least < about_noise * of_noise;
  if (!(least < (is_noise ? clearly_better : far_better) * precisely.miss_of_right())) return {};
  // By chance, noise lets the sum of squares, in units of its variance, differ by no more. Its
  // variance may be overestimated, so that even a law leaves less.
  constexpr double as_well = 3, of_methods = 1e-6, of_chance = 30;
  const double chance = std::sqrt(of_chance / precisely.count()) * std::max(least, of_noise);
  const double most = std::max(is_noise ? std::hypot(least, chance) : as_well * least, of_methods);
  std::erase_if(all, [most](const Explanation& one) { return !(one.miss <= most); });
  // In noise, fewer numbers explain about as much, too, and only usual ones are no coincidence.
  const int fewest = std::ranges::min(all, {}, &Explanation::free_numbers).free_numbers;
  if (is_noise && fewest > 0) return all;
  std::erase_if(all, [fewest](const Explanation& one) { return one.free_numbers > fewest; });
  return all;
}

std::vector<Explanation> explanations(const Comparer& roughly, const Comparer& precisely,
                                      const std::vector<Candidate>& candidates) {
  std::vector<Explanation> rough_fits;
  for (const Candidate& candidate : candidates) rough_fits.push_back(roughly.fitted(candidate));
  const Explanation nearest = std::ranges::min(rough_fits, {}, &Explanation::miss);
  const double least = nearest.miss;
  // A precise fit takes long, so it is omitted where best() would refuse it.
  constexpr double far_worse = 3, of_large_steps = 1e-3, too_little = 0.05;
  const double of_noise = roughly.miss_of_noise(nearest.law);
  if (least > std::max(too_little * precisely.miss_of_right(), far_worse * of_noise)) return {};
  const double most = std::max(far_worse * least, of_large_steps);
  std::vector<Explanation> all;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (rough_fits[i].miss <= most) all.push_back(precisely.fitted(candidates[i]));
  }
  return best(std::move(all), precisely);
}

/// A smaller miss is that of an integrator, and not worth an explanation.
constexpr double good = 1e-4;

}  // namespace

WrongLaws wrong_laws(const Matrix3d& inertia, std::span<const Row> rows, RowParts parts,
                     const RelativeNoise& noise) {
  constexpr std::size_t enough = 8;
  if (rows.size() < enough) return {};
  const Pairs few = pairs_of(rows, noise.rates, rough);
  const Pairs many = pairs_of(rows, noise.rates, precise);
  const RowScales& scales = many.scales;
  const double turn = scales.speed * scales.step;
  constexpr double too_far = 2;  // rad
  if (!(turn > 0 && turn < too_far)) return {};
  const Law right{.inertia = inertia};
  const Comparer of_rates(many, rates_of(many, noise), right, noise.rates);
  WrongLaws found;
  found.rates_miss = of_rates.miss_of_right();
  if (found.rates_miss > good) {
    found.of_rates =
        explanations(Comparer(few, rates_of(few, noise), right, noise.rates), of_rates,
                     parts == RowParts::attitude
                         ? candidates_for_attitude_alone(inertia, scales)
                         : candidates_for_rates(inertia, scales, parts == RowParts::both));
  }
  found.attitude_miss = 0;
  if (parts != RowParts::both) return found;
  // Rates that follow no law let the attitude miss more than noise does.
  const bool rates_follow = !found.of_rates.empty() || found.rates_miss < good ||
                            found.rates_miss < about_noise * of_rates.miss_of_noise(right);
  const RelativeNoise known = rates_follow ? noise : RelativeNoise{0, 0};
  const Law law = found.of_rates.empty() ? right : found.of_rates.front().law;
  const Comparer of_attitude(many, attitude_of(known), law, known.rates);
  found.attitude_miss = of_attitude.miss_of_right();
  if (found.attitude_miss > good) {
    found.of_attitude = explanations(Comparer(few, attitude_of(known), law, known.rates),
                                     of_attitude, candidates_for_attitude(scales));
  }
  return found;
}

LawMiss free_body_miss(const Matrix3d& inertia, std::span<const Row> rows, RowParts parts,
                       const RelativeNoise& noise) {
  const Pairs pairs = pairs_of(rows, noise.rates, precise);
  const Law right{.inertia = inertia};
  const auto miss = [&](const Aspect& aspect) {
    return Comparer(pairs, aspect, right, noise.rates).miss_of_right();
  };
  return {miss(rates_of(pairs, noise)), parts == RowParts::both ? miss(attitude_of(noise)) : 0};
}

}  // namespace twrench::check
