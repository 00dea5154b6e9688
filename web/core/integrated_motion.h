#pragma once

#include <twrench/study/flip_search.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/interior_series.h"

namespace twrench::page {

/// The motion of a body without a closed form, integrated from t = 0 with the method `taylor` at
/// its tightest tolerance. The beginning of each step is kept, so that a sample costs the same at
/// any earlier time, and has the same digits in whatever order the times are requested.
class IntegratedMotion {
 public:
  explicit IntegratedMotion(const motion::FreeBody& body);

  /// Returns the sample at t in s. Throws OutOfRange unless t is from 0 to longest().
  motion::Sample at(double t);

  /// The greatest t in s. The steps until then take at most about a second and 20 MB.
  double longest() const { return longest_; }

  /// Returns the number of flips until t in s: of sign changes of omega along the intermediate
  /// axis. Throws as at() does.
  std::size_t flips_until(double t);

  /// Returns the time in s of flip `n`, counted from 0; nothing if there is none before longest().
  std::optional<double> flip(std::size_t n);

 private:
  struct Step {
    double t;  ///< Beginning in s.
    motion::InteriorSeries::State state;
  };

  void expand(std::size_t step);
  void advance();

  motion::FreeBody body_;
  double longest_;
  motion::InteriorSeries series_;
  study::FlipSearch flips_;
  std::vector<Step> steps_;              ///< The last one has not been taken yet.
  std::optional<std::size_t> expanded_;  ///< Step about whose beginning series_ is expanded.
};

/// Returns whether a body without energy loss turns over: whether its intermediate axis swings
/// through at least a right angle, and omega along that axis changes its sign.
bool turns_over(const motion::FreeBody& body);

}  // namespace twrench::page
