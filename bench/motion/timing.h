#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace twrench::bench {

inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// CPU seconds of one call, averaged over two milliseconds of calls.
template <class Work>
double seconds_each(Work&& work) {
  constexpr double enough = 2e-3;
  const double start = cpu_seconds();
  double spent = 0;
  int calls = 0;
  while (spent < enough) {
    work();
    ++calls;
    spent = cpu_seconds() - start;
  }
  return spent / calls;
}

/// The minimum of a few single calls, fewer if they are long: for a first estimate.
template <class Work>
double seconds_at_best(Work&& work) {
  constexpr double enough = 1e-3;
  const double first = cpu_seconds();
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4 && cpu_seconds() - first < enough; ++i) {
    const double start = cpu_seconds();
    work();
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

}  // namespace twrench::bench
