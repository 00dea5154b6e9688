#include "check/verdict/exact_rows.h"

namespace twrench::check {

void ExactRows::evaluate(const motion::ExactMotion& exact, std::span<const double> times) {
  X_.resize(9 * times.size());
  omega_.resize(3 * times.size());
  exact.at(times, X_, omega_);
}

void ExactRows::evaluate(const motion::ExactMotion& exact, double start,
                         std::span<const recording::Row> rows) {
  times_.clear();
  for (const recording::Row& row : rows) times_.push_back(row.t - start);
  evaluate(exact, times_);
}

}  // namespace twrench::check
