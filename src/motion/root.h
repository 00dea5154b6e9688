#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <limits>

namespace twrench::motion {

/// Returns where f is 0 between 0 and `end`, to round-off. Its values `at_start` and `at_end` at
/// these places must have different signs.
template <class Function>
double root_within(const Function& f, double end, double at_start, double at_end) {
  const boost::math::tools::eps_tolerance<double> tight(std::numeric_limits<double>::digits - 3);
  std::uintmax_t iterations = 100;
  const auto [low, high] =
      boost::math::tools::toms748_solve(f, 0.0, end, at_start, at_end, tight, iterations);
  return low + 0.5 * (high - low);
}

}  // namespace twrench::motion
