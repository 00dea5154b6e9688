#include "check/report/checked_file.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <atomic>
#include <numbers>

#include "base/words.h"
#include "check/report/choice.h"
#include "check/verdict/error.h"
#include "check/verdict/fit.h"
#include "check/verdict/free_flight.h"
#include "check/verdict/stop.h"
#include "recording/columns/unread_columns.h"
#include "recording/row_reader.h"
#include "recording/rows.h"
#include "study/ladder.h"

namespace twrench::check {
namespace {

using recording::Convention;

/// Throws InvalidArgument: the bound is for a quantity that the file does not have.
[[noreturn]] void refuse_bound(const std::string& name, const std::string& file,
                               const char* missing) {
  throw InvalidArgument(argument(name),
                        fmt::format("{} has no {} to compare with the bound", file, missing),
                        "leave it out");
}

std::vector<CheckBound> applied(const Bounds& given, const std::string& file,
                                const Judgement& judgement) {
  std::vector<CheckBound> bounds;
  if (given.attitude_error) {
    const std::string name = "max_attitude_error";
    if (!judgement.attitude) refuse_bound(name, file, "attitude");
    bounds.push_back({name, "deg", *given.attitude_error, degrees(judgement.attitude->max)});
  }
  if (given.rate_error) {
    const std::string name = "max_rate_error";
    const RateScale unit = rate_scale(judgement);
    if (!judgement.rates) refuse_bound(name, file, "rates");
    bounds.push_back(
        {name, unit.symbol, *given.rate_error, judgement.rates->max * unit.per_radian});
  }
  if (given.energy_drift) {
    const std::string name = "max_energy_drift";
    bounds.push_back({name, "", *given.energy_drift, judgement.energy_drift});
  }
  return bounds;
}

/// The fit of the initial state, if the rows begin in another state than the given one.
std::optional<Fit> other_start_of(const recording::Recording& recording, const CheckedFile& file,
                                  Problem problem) try {
  if (verdict(file).finding != Finding::start) return std::nullopt;
  problem.omega.reset();
  problem.fit = true;
  return judge(recording, file.judgement.convention, problem).fit;
} catch (const CheckError&) {
  return std::nullopt;  // it is at rest
}

/// The exponent of the errors, from the files whose errors exceed their digits and can still grow:
/// errors of rates are at most about |omega|, those of attitudes half a turn.
std::optional<double> order(const std::vector<CheckedFile>& files,
                            std::optional<ErrorSize> Judgement::*errors) {
  std::vector<study::PowerLawPoint> points;
  for (const CheckedFile& file : files) {
    const auto& size = file.judgement.*errors;
    const double speed = file.judgement.reference.body.omega().norm();
    const double most = errors == &Judgement::rates ? speed / 2 : std::numbers::pi / 2;
    if (size && size->max > 0 && size->max < most && !file.judgement.within_digits) {
      points.push_back({file.step, size->max});
    }
  }
  return study::fitted_exponent(points);
}

/// Why the files do not determine an order, if they do not.
std::string why_no_order(const std::vector<CheckedFile>& files, bool has_steps) {
  const auto [least, most] = std::ranges::minmax_element(files, {}, &CheckedFile::step);
  constexpr double alike = 1.01;
  if (most->step <= alike * least->step) {
    return has_steps ? "the step sizes that " + argument("steps") + " gives are the same"
                     : "the files have the same time between rows; give their step sizes with " +
                           argument("steps");
  }
  const auto end = [](const CheckedFile& file) {
    return clock_time(file.judgement, file.judgement.duration);
  };
  const auto [first, last] = std::ranges::minmax_element(files, {}, end);
  if (end(*last) - end(*first) > 1.5 * most->step) return "the files end at different times";
  return {};
}

/// Evenly spread rows with their rates.
recording::ThinnedRows spread_rows(const recording::Recording& recording, const Convention& given,
                                   const std::atomic<bool>* stop) {
  recording::ThinnedRows thinned(most_fitted_rows);
  recording::RowReader reader = recording.rows(choose_rates(recording, given));
  for (recording::Row row; reader.next(row);) {
    throw_if_stopped(stop);
    thinned.add(row);
  }
  return thinned;
}

/// The inertia matrix that fits the rates. Throws CheckError if they do not determine it.
FittedInertia inertia_of(const recording::Recording& recording, const Convention& given,
                         const std::atomic<bool>* stop) {
  return fit_inertia(recording.name(), spread_rows(recording, given, stop).rows(), stop);
}

bool follows_free_motion(const CheckedFile& file) {
  const Finding finding = verdict(file).finding;
  return finding == Finding::exact || finding == Finding::noise;
}

/// The part of the recording, whatever part of it is checked, that follows a free motion within its
/// noise; the moments are fitted to it.
std::optional<recording::Extract> free_rows(const recording::Recording& recording,
                                            const Convention& given, Problem problem) try {
  const recording::ThinnedRows all = spread_rows(recording.between({}), given, problem.stop);
  std::optional<recording::Extract> part = free_flight(all.rows());
  if (!part) return std::nullopt;
  problem.fit = true;
  constexpr int most_trials = 3;
  constexpr double shrinking = 0.03;  // at either end
  for (int i = 0; i < most_trials; ++i) {
    try {
      const recording::Recording cut = recording.between(*part);
      problem.inertia = inertia_of(cut, given, problem.stop).inertia;
      const Convention convention = choose_convention(cut, given, problem);
      if (follows_free_motion({cut.name(), judge(cut, convention, problem), {}, {}, {}, 0}))
        return part;
    } catch (const CheckError& error) {
      if (error.reason() == CheckError::Reason::stopped) throw;
    }
    const double less = shrinking * (part->to - part->from);
    part->from += less, part->to -= less;
  }
  return std::nullopt;
} catch (const InvalidArgument&) {
  return std::nullopt;  // rows that are not checked have no numbers
}

/// The inertia that fits the rates. Throws CheckError, which names rows that determine it, if all
/// of them do not.
FittedInertia inertia_or_remedy(const recording::Recording& recording, const Convention& given,
                                const Problem& problem) try {
  return inertia_of(recording, given, problem.stop);
} catch (const CheckError& error) {
  if (error.reason() != CheckError::Reason::no_inertia) throw;
  const auto part = free_rows(recording, given, problem);
  if (!part) throw;
  throw CheckError(recording.name(), "no free motion that determines the moments fits all its rows",
                   error.reason(), free_rows_text(*part));
}

CheckedFile check_file(recording::Recording recording, const Convention& given, Problem problem,
                       const Bounds& bounds) {
  std::optional<FittedInertia> inertia;
  if (problem.fits_inertia) {
    inertia = inertia_or_remedy(recording, given, problem);
    problem.inertia = inertia->inertia;
    problem.fit = true;
  }
  const Convention convention = choose_convention(recording, given, problem);
  CheckedFile file{recording.name(), judge(recording, convention, problem), {}, {}, {}, 0};
  file.inertia = inertia;
  file.left_out = recording.left_out();
  file.alternatives = better_readings(recording, problem, file.judgement);
  file.other_start = other_start_of(recording, file, problem);
  if (given.columns.empty()) file.unread = unread_columns(recording.header(), convention);
  file.bounds = applied(bounds, file.name, file.judgement);
  if (file.judgement.rows > 1) {
    file.step = file.judgement.duration / static_cast<double>(file.judgement.rows - 1);
  }
  if (problem.fits_inertia && !follows_free_motion(file))
    file.free_rows = free_rows(recording, given, problem);
  return file;
}

/// How the errors of files depend on their steps. `has_steps` is whether the user gave these.
CheckOrders orders_of(const std::vector<CheckedFile>& files, bool has_steps) {
  if (files.size() < 2) return {};
  CheckOrders orders{{}, {}, why_no_order(files, has_steps)};
  if (!orders.why_not.empty()) return orders;
  orders.rates = order(files, &Judgement::rates);
  orders.attitude = order(files, &Judgement::attitude);
  if (!orders.rates && !orders.attitude) {
    orders.why_not =
        "fewer than two files have errors that their digits do not explain and that can still grow";
  }
  return orders;
}

}  // namespace

CheckResult check_files(std::size_t count,
                        const std::function<recording::Recording(std::size_t)>& open,
                        const std::vector<double>& steps, const Convention& given,
                        const Problem& problem, const Bounds& bounds) {
  if (!steps.empty() && steps.size() != count) {
    throw InvalidArgument(argument("steps"),
                          fmt::format("has {} step size{} for {} file{}", steps.size(),
                                      steps.size() == 1 ? "" : "s", count, count == 1 ? "" : "s"));
  }
  CheckResult result;
  for (std::size_t i = 0; i < count; ++i) {
    result.files.push_back(check_file(open(i), given, problem, bounds));
    if (!steps.empty()) result.files.back().step = steps[i];
  }
  result.orders = orders_of(result.files, !steps.empty());
  return result;
}

}  // namespace twrench::check
