#include "check/hypotheses/lawful_readings.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "check/law/attitude_rates.h"
#include "check/verdict/error.h"
#include "check/verdict/fit.h"
#include "check/verdict/stop.h"
#include "recording/informative_rows.h"
#include "recording/row_reader.h"
#include "table/error.h"

namespace twrench::check {
namespace {

using recording::Convention;
using recording::Recording;
using recording::Row;

/// Rows that are spread over the whole file, or those of its beginning if the body turns by more
/// than about a radian between the former.
std::vector<Row> spread_rows(const Recording& recording, const Problem& problem,
                             const Convention& convention) {
  recording::ThinnedRows thinned(most_fitted_rows);
  recording::RowReader reader = recording.rows(convention);
  Row row, before;
  double speed = 0;
  while (reader.next(row)) {
    throw_if_stopped(problem.stop);
    thinned.add(row);
    const bool is_implied = !reader.has_rates() && row.number > 1;
    speed = std::max(speed, is_implied
                                ? so3::log(before.X.transpose() * row.X).norm() / (row.t - before.t)
                                : row.omega.norm());
    before = row;
  }
  const double turn = speed * row.t / static_cast<double>(thinned.rows().size());
  return turn < 1 ? thinned.rows() : beginning(recording, convention, most_fitted_rows);
}

}  // namespace

RowParts parts_of(const Judgement& judgement) {
  if (!judgement.has_attitude) return RowParts::rates;
  return judgement.has_rates ? RowParts::both : RowParts::attitude;
}

LawRows law_rows(const Recording& recording, const Problem& problem, const Convention& convention,
                 const Judgement& judgement) {
  std::vector<Row> rows = spread_rows(recording, problem, convention);
  const Noise& noise = judgement.noise;
  if (judgement.has_rates) {
    const double speed = judgement.reference.body.omega().norm();
    return {std::move(rows), {noise.rate / speed, noise.attitude}};
  }
  const double error = std::max(noise.attitude, judgement.digits.attitude);
  RowsWithRates derived = with_rates_of_attitude(rows, error);
  const bool is_noise = noise.attitude > 0;
  return {std::move(derived.rows), {is_noise ? derived.noise : 0, noise.attitude}};
}

WrongLaws laws_of(const Recording& recording, const Problem& problem, const Judgement& judgement) {
  if (judgement.reference.body.omega().norm() == 0) return {};
  const LawRows law = law_rows(recording, problem, judgement.convention, judgement);
  return wrong_laws(problem.inertia, law.rows, parts_of(judgement), law.noise);
}

LawMiss miss_of(const WrongLaws& laws) {
  const auto least = [](const std::vector<Explanation>& all, double as_read) {
    return all.empty() ? as_read : std::ranges::min(all, {}, &Explanation::miss).miss;
  };
  return {least(laws.of_rates, laws.rates_miss), least(laws.of_attitude, laws.attitude_miss)};
}

namespace {

/// The root mean square difference between the rates and those of the attitude, relative to the
/// rates. Infinite if there are too few rows.
double miss_of_kinematics(const LawRows& law) {
  const std::vector<Row> derived = with_rates_of_attitude(law.rows, law.noise.attitude).rows;
  double squares = 0, differences = 0;
  auto row = law.rows.begin();
  for (const Row& other : derived) {
    while (row->number != other.number) ++row;
    squares += row->omega.squaredNorm();
    differences += (row->omega - other.omega).squaredNorm();
  }
  return squares > 0 ? std::sqrt(differences / squares) : std::numeric_limits<double>::infinity();
}

/// Explains the rows by the best law or, if that leaves less, by the kinematics, which rates of an
/// unknown law follow, too.
Lawful lawful(const Recording& recording, const Problem& problem, const Convention& convention) {
  const Judgement judgement = judge(recording, convention, problem);
  const WrongLaws laws = laws_of(recording, problem, judgement);
  Lawful result{{convention, judgement.misfit}, miss_of(laws).worst(), 0};
  for (const auto* list : {&laws.of_rates, &laws.of_attitude}) {
    if (!list->empty()) result.free_numbers += list->front().free_numbers;
  }
  if (parts_of(judgement) == RowParts::both) {
    const LawRows rows = law_rows(recording, problem, convention, judgement);
    result.miss = std::min(result.miss, miss_of_kinematics(rows));
  }
  return result;
}

}  // namespace

double miss_of_free_body(const Recording& recording, const Problem& problem,
                         const Convention& convention) {
  const Judgement judgement = judge(recording, convention, problem);
  const auto [rows, noise] = law_rows(recording, problem, convention, judgement);
  if (rows.empty()) return 0;
  return free_body_miss(problem.inertia, rows, parts_of(judgement), noise).worst();
}

std::optional<Lawful> only_lawful(const Recording& recording, const Problem& problem,
                                  std::span<const Convention> conventions) {
  std::vector<Lawful> all;
  for (const Convention& convention : conventions) {
    try {
      all.push_back(lawful(recording, problem, convention));
    } catch (const table::BadTable&) {
      continue;  // it does not allow these numbers
    } catch (const CheckError&) {
      continue;  // no state of the body fits
    }
  }
  if (all.empty()) return {};
  constexpr double explained = 0.05, far_worse = 5, contradicts = 1e-3;
  const double least = std::ranges::min(all, {}, &Lawful::miss).miss;
  if (least >= explained) return {};
  const double most = std::max(far_worse * least, contradicts);
  std::erase_if(all, [most](const Lawful& one) { return one.miss >= most; });
  // A fitted number explains a part of anything.
  const int fewest = std::ranges::min(all, {}, &Lawful::free_numbers).free_numbers;
  std::erase_if(all, [fewest](const Lawful& one) { return one.free_numbers > fewest; });
  return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
}

}  // namespace twrench::check
