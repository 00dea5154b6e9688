#include "check/hypotheses/hypotheses.h"

#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "check/hypotheses/changed_rows.h"
#include "check/hypotheses/lawful_readings.h"
#include "check/hypotheses/other_conventions.h"
#include "check/hypotheses/readings.h"
#include "check/law/mistakes.h"
#include "check/verdict/error.h"
#include "check/verdict/fit.h"
#include "recording/conventions/units.h"
#include "recording/informative_rows.h"
#include "recording/rows.h"
#include "table/error.h"

namespace twrench::check {
namespace {

using recording::BodyAxes;
using recording::Convention;
using recording::Recording;
using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A reading with a larger misfit does not fit.
constexpr double follows = 0.2;

/// A factor of the rates. The physics depends only on the products of rates and times.
struct Scale {
  double factor;
  std::vector<Units> units;  ///< with this factor; those as read come first
};

/// The rows in one reading of the attitude, with unchanged rates and axes.
struct Variant {
  Convention convention;
  std::vector<Row> rows;
};

std::vector<Scale> scales(const std::vector<Units>& units) {
  std::vector<Scale> list;
  const auto in_si = [](const Units& u) { return name_of(u.time).in_s * name_of(u.rate).in_rad_s; };
  for (const Units& u : units) {
    const double factor = in_si(u) / in_si(units.front());
    constexpr double same_factor = 1e-12;
    const auto same = std::ranges::find_if(list, [&](const Scale& scale) {
      return std::abs(scale.factor / factor - 1) < same_factor;
    });
    if (same != list.end()) {
      same->units.push_back(u);
    } else {
      list.push_back({factor, {u}});
    }
  }
  return list;
}

/// A reading that was tried, and the rows in it.
struct Tried {
  Reading reading;
  std::vector<Row> rows;
};

/// The columns that may be read differently.
enum class Open { all, attitude };

/// Tries the readings of one file.
class Search {
 public:
  Search(recording::RowSample numbers, const Problem& problem, const Convention& convention,
         Open open)
      : numbers_(std::move(numbers)),
        problem_(problem),
        convention_(convention),
        has_rates_(recording::has_rates(convention)),
        has_attitude_(attitude_form(convention) != recording::AttitudeForm::none),
        open_(open),
        axes_(open == Open::all ? distinct_axes(problem.inertia, convention.axes)
                                : std::vector{convention.axes}),
        scales_(scales(unit_readings(numbers_.header, convention))) {
    if (open == Open::attitude) scales_.resize(1);  // the first one is as read
    Convention plain = convention;
    plain.axes = BodyAxes();
    plain.offset.reset();
    plain.rates_in_space = false;
    for (const Convention& reading : attitude_readings(plain)) {
      try {
        variants_.push_back({reading, decoded(numbers_, reading)});
      } catch (const table::BadTable&) {
        continue;  // it does not allow these numbers
      }
    }
  }

  Alternatives run() {
    if (stands_still()) return {};
    if (has_rates_) try_rates_in_body();
    if (has_rates_ && has_attitude_ && open_ == Open::all) try_rates_in_space();
    if (!has_rates_) try_attitude_alone();
    if (has_rates_ && has_attitude_ && !any_fits_well()) try_offsets();
    return chosen();
  }

 private:
  /// Whether the attitude never changes although the rates turn the body: no reading mends that.
  bool stands_still() const {
    if (!has_rates_ || !has_attitude_ || variants_.empty()) return false;
    constexpr double turned = 1;  // rad
    const std::vector<Row>& rows = variants_.front().rows;
    double angle = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (rows[i].X != rows[0].X) return false;
      angle += (rows[i].t - rows[i - 1].t) * rows[i].omega.norm();
    }
    return angle > turned;
  }

  bool any_fits_well() const {
    constexpr double well = 1e-3;
    return std::ranges::any_of(found_,
                               [](const Tried& t) { return *t.reading.misfit.worst() < well; });
  }

  Change change_to(double factor, const BodyAxes& axes, bool from_space_axes = false) const {
    Change change{factor, axes, from_space_axes};
    if (has_momentum(convention_)) change.file_from_rates = convention_.inertia;
    return change;
  }

  void try_rates_in_body() {
    if (variants_.empty()) return;
    for (const Scale& scale : scales_) {
      for (const BodyAxes& axes : axes_) {
        const Change change = change_to(scale.factor, axes);
        const auto rows = changed(variants_.front().rows, change);
        const auto miss = quick_misfit_of_rates(problem_.inertia, rows);
        if (miss.value_or(0) >= follows) continue;
        if (miss) following_.emplace_back(&scale, axes);
        for (const Variant& variant : variants_) test(variant, scale, change);
      }
    }
  }

  void try_rates_in_space() {
    for (const Variant& variant : variants_) {
      for (const BodyAxes& axes : axes_) {
        constexpr double conserved = 0.2;  // more than what coarse methods lose
        const auto unscaled = changed(variant.rows, change_to(1, axes, true));
        if (variation(problem_.inertia, unscaled) >= conserved) continue;
        for (const Scale& scale : scales_)
          test(variant, scale, change_to(scale.factor, axes, true));
      }
    }
  }

  /// Attitudes alone also fit faster or slower motions, so they do not determine the unit of the
  /// times.
  void try_attitude_alone() {
    for (const Variant& variant : variants_) {
      for (const Scale& scale : scales_) {
        const bool is_tested = scale.factor == 1 || problem_.omega;
        for (const BodyAxes& axes : axes_) {
          if (is_tested) test(variant, {1, scale.units}, change_to(1, axes));
        }
      }
    }
  }

  void try_offsets() {
    for (const auto& [scale, axes] : following_) {
      Change change = change_to(scale->factor, axes);
      const auto rates = changed(variants_.front().rows, change);
      for (const Variant& variant : variants_) {
        change.offset = offset_between(problem_.inertia, variant.rows, rates, axes);
        test(variant, *scale, change);
      }
    }
  }

  /// Keeps the reading if it may fit.
  void test(const Variant& variant, const Scale& scale, const Change& change) {
    const auto rows = changed(variant.rows, change);
    const auto quick = has_attitude_ ? quick_misfit_of_attitude(problem_.inertia, rows, has_rates_)
                                     : quick_misfit_of_rates(problem_.inertia, rows);
    constexpr double clearly_none = 2 * follows;
    if (quick && *quick >= std::min(clearly_none, nearest_)) return;
    const Misfit found = misfit(problem_.inertia, rows, has_rates_, has_attitude_);
    if (!found.worst()) return;
    nearest_ = std::max(follows, std::min(nearest_, *found.worst()));
    for (const Units& units : scale.units) {
      if (!agrees_with_omega(rows, scale.factor, units)) continue;
      found_.push_back({{convention_of(variant, units, change), found}, rows});
    }
  }

  /// If the angular velocity is given, that of the rows must have about the same magnitude in these
  /// units. The rates of the rows are already multiplied by `factor`.
  bool agrees_with_omega(const std::vector<Row>& rows, double factor, const Units& units) const {
    if (!problem_.omega || rows.size() < 2) return true;
    const double given = problem_.omega->norm();
    const double faster = name_of(units.rate).in_rad_s / name_of(rate_unit(convention_)).in_rad_s;
    const double found =
        has_rates_ ? faster / factor * rows[0].omega.norm()
                   : omega_between(problem_.inertia, rows[0], rows[1]).norm() / seconds(units.time);
    // Between the two times, the rates can change by as much as the moments differ.
    constexpr double about = 7;
    return found <= about * given && given <= about * found;
  }

  /// The size of `unit` in the unit of the times as read.
  double seconds(recording::TimeUnit unit) const {
    return name_of(unit).in_s / name_of(time_unit(convention_)).in_s;
  }

  /// If the angular velocity is given, it distinguishes axes that the motion does not.
  void turn_to_omega(Tried& tried) const {
    if (!problem_.omega || tried.rows.size() < 2) return;
    const double unit = seconds(time_unit(tried.reading.convention));
    const Row& first = tried.rows.front();
    const double first_time =
        name_of(time_unit(tried.reading.convention)).in_s * numbers_.rows[0][0].value;
    const double t = first_time - problem_.omega_time.value_or(first_time);
    const Vector3d given = motion::ExactMotion({problem_.inertia, *problem_.omega}).at(t).omega;
    // Only the products of rates and times are right in the rows that were tested.
    const Vector3d found =
        (has_rates_ ? first.omega : omega_between(problem_.inertia, first, tried.rows[1])) / unit;
    const BodyAxes axes = tried.reading.convention.axes;
    Matrix3d turn = Matrix3d::Identity();
    constexpr double about = 0.05;
    double least = std::min((found - given).norm(), about * given.norm());
    for (const BodyAxes& other : recording::all_body_axes()) {
      if (!are_equivalent(problem_.inertia, axes, other)) continue;
      const Matrix3d S = other.matrix().transpose() * axes.matrix();
      constexpr double clearly = 0.99;
      if ((S * found - given).norm() >= clearly * least) continue;
      least = (S * found - given).norm();
      turn = S;
      tried.reading.convention.axes = other;
    }
    for (Row& row : tried.rows) {
      row.omega = (turn * row.omega).eval();
      row.X = (row.X * turn.transpose()).eval();
    }
  }

  Convention convention_of(const Variant& variant, const Units& units, const Change& change) const {
    Convention reading = variant.convention;
    if (units.time != time_unit(convention_)) reading.time_unit = units.time;
    if (units.rate != rate_unit(convention_)) reading.rate_unit = units.rate;
    reading.axes = change.axes;
    reading.rates_in_space = change.from_space_axes;
    if (!change.offset.isIdentity(0)) reading.offset = Eigen::Quaterniond(change.offset);
    return reading;
  }

  Alternatives chosen() {
    const auto worst = [](const Tried& tried) { return *tried.reading.misfit.worst(); };
    const auto changes = [&](const Tried& tried) {
      return count_changes(convention_, tried.reading.convention);
    };
    if (found_.empty()) return {};
    const Tried best = *std::ranges::min_element(found_, {}, worst);
    if (!best.reading.misfit.fits()) return {.nearest = best.reading};
    constexpr double far_worse = 20, round_off = 1e-8;
    const double most = std::min(follows, far_worse * worst(best) + round_off);
    std::erase_if(found_, [&](const Tried& tried) { return worst(tried) >= most; });
    for (Tried& tried : found_) turn_to_omega(tried);
    const int fewest = changes(*std::ranges::min_element(found_, {}, changes));
    // The convention as read fits no worse.
    if (fewest == 0) return {};
    std::erase_if(found_, [&](const Tried& tried) { return changes(tried) > fewest; });
    return {.fitting = distinct()};
  }

  /// One reading for each motion and each unit of times.
  std::vector<Reading> distinct() const {
    std::vector<Tried> kept;
    for (const Tried& tried : found_) {
      const auto is_same = [&](const Tried& other) {
        return time_unit(tried.reading.convention) == time_unit(other.reading.convention) &&
               are_same_motion(problem_.inertia, tried.rows, other.rows);
      };
      if (std::ranges::none_of(kept, is_same)) kept.push_back(tried);
    }
    std::vector<Reading> readings;
    for (const Tried& tried : kept) readings.push_back(tried.reading);
    return readings;
  }

  recording::RowSample numbers_;
  const Problem& problem_;
  Convention convention_;
  bool has_rates_, has_attitude_;
  Open open_;
  std::vector<BodyAxes> axes_;
  std::vector<Scale> scales_;
  std::vector<Variant> variants_;
  std::vector<std::pair<const Scale*, BodyAxes>> following_;  ///< with which the rates follow
  std::vector<Tried> found_;
  double nearest_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Alternatives alternatives(const Recording& recording, const Problem& problem,
                          const Convention& convention) {
  return Search(read_row_sample(recording, convention), problem, convention, Open::all).run();
}

namespace {

/// Whether the digits and the noise explain all errors in the reading.
bool follows_within_noise(const Recording& recording, const Problem& problem,
                          const Reading& reading) {
  try {
    return judge(recording, reading.convention, problem).within_noise;
  } catch (const table::BadTable&) {
    return false;  // a unit seems to change
  } catch (const CheckError& error) {
    if (error.reason() != CheckError::Reason::no_fit) throw;
    return false;
  }
}

/// Whether a reading leaves clearly more than a law of what changes. Errors of methods blur both.
bool is_worse(double of_reading, double of_law) {
  constexpr double worse = 1.1, of_methods = 1e-4, far_worse = 20, round_off = 1e-8;
  return of_reading > std::max(worse * of_law, of_methods) ||
         of_reading > far_worse * of_law + round_off;
}

/// Removes the readings that do not explain all rows, and keeps the nearest of them: those that
/// leave more than a wrong law does, or more than so many changes of the reading must explain,
/// unless the file follows the motion within its noise. Each change can explain a part of anything,
/// so each further one must explain more.
void remove_partial_fits(Alternatives& found, const Recording& recording, const Problem& problem,
                         const Judgement& judgement, const LawMiss& of_law) {
  const auto is_partial = [&](const Reading& reading) {
    const auto [rows, noise] = law_rows(recording, problem, reading.convention, judgement);
    if (rows.empty()) return false;
    const LawMiss miss = free_body_miss(problem.inertia, rows, parts_of(judgement), noise);
    if (is_worse(miss.rates, of_law.rates) || is_worse(miss.attitude, of_law.attitude)) return true;
    constexpr double of_one_change = 0.2, of_each_more = 0.1;
    const int changes = count_changes(judgement.convention, reading.convention);
    return miss.worst() > of_one_change * std::pow(of_each_more, changes - 1);
  };
  const std::vector<Reading> all = found.fitting;
  std::erase_if(found.fitting, [&](const Reading& reading) {
    return is_partial(reading) && !follows_within_noise(recording, problem, reading);
  });
  if (found.fitting.empty() && !all.empty()) found.nearest = all.front();
}

/// The readings with nearly equal moments exchanged in which the file follows the motion within its
/// noise. No other mistake of a reading makes errors as small as those of a method.
std::vector<Reading> exact_with_moments_exchanged(const Recording& recording,
                                                  const Problem& problem,
                                                  const Judgement& judgement) {
  if (judgement.within_noise) return {};
  const Matrix3d& inertia = problem.inertia;
  const BodyAxes as_read = judgement.convention.axes;
  std::vector<Convention> conventions;
  for (const BodyAxes& axes : distinct_axes(inertia, as_read)) {
    const Matrix3d S = axes.matrix().transpose() * as_read.matrix();
    constexpr double nearly = 1e-2;
    const bool is_near = (S * inertia * S.transpose() - inertia).norm() < nearly * inertia.norm();
    if (axes == as_read || S.determinant() < 0 || !is_near) continue;
    conventions.push_back(judgement.convention);
    conventions.back().axes = axes;
  }
  std::vector<Reading> found = readings(recording, inertia, conventions);
  std::erase_if(found, [&](const Reading& reading) {
    return !follows_within_noise(recording, problem, reading);
  });
  return found;
}

/// Whether a single mistake that is usual explains both the rates and the attitude.
bool is_one_usual_mistake(const WrongLaws& laws) {
  constexpr double explained = 1e-3;
  const std::vector<Explanation>& of_rates = laws.of_rates;
  return !of_rates.empty() && of_rates.front().free_numbers == 0 && laws.of_attitude.empty() &&
         laws.attitude_miss < explained;
}

}  // namespace

Alternatives better_readings(const Recording& recording, const Problem& problem,
                             const Judgement& judgement) {
  const auto miss = judgement.misfit.worst();
  constexpr double good = 1e-4, far_better = 1e-2, another = 0.1;
  if (!miss) return {.fitting = exact_with_moments_exchanged(recording, problem, judgement)};
  const double speed = judgement.reference.body.omega().norm();
  const bool is_of_another_start =
      problem.omega && (!judgement.has_rates || judgement.first_rate_error > another * speed);
  const WrongLaws laws = laws_of(recording, problem, judgement);
  if (*miss < good && !is_of_another_start) {
    std::vector<Reading> exact = exact_with_moments_exchanged(recording, problem, judgement);
    // Few rows may follow another law, such as those at a limit of the speed.
    if (exact.empty()) return {.laws = laws};
    return {.fitting = std::move(exact)};
  }
  const bool is_usual = is_one_usual_mistake(laws);
  // Rates alone are those of a reversed gyroscopic term in a reading with mirrored axes, too, and
  // attitudes alone those of swapped factors if they are inverse as well.
  const bool is_reading =
      is_usual && (judgement.has_rates ? !judgement.has_attitude
                                       : laws.of_rates.front().mistake == Mistake::swapped_factors);
  if (is_usual && !is_reading) return {.laws = laws};
  const bool rates_follow = judgement.has_rates && judgement.has_attitude && !is_of_another_start &&
                            judgement.misfit.rates && laws.rates_miss < good;
  Alternatives found = Search(read_row_sample(recording, judgement.convention), problem,
                              judgement.convention, rates_follow ? Open::attitude : Open::all)
                           .run();
  const bool is_better =
      !found.fitting.empty() && *found.fitting.front().misfit.worst() < far_better * *miss;
  if (judgement.misfit.fits() && !is_of_another_start && !is_better) found = {};
  remove_partial_fits(found, recording, problem, judgement, miss_of(laws));
  // A reading that explains everything is simpler than a fitted number, or than two mistakes.
  if (found.fitting.empty() || is_usual) found.laws = laws;
  return found;
}

}  // namespace twrench::check
