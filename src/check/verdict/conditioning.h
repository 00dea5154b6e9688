#pragma once

#include <twrench/motion/free_body.h>

#include <span>
#include <vector>

namespace twrench::check {

/// How much a small error of the initial angular velocity has grown at a time, at most, whatever
/// its direction.
struct Growth {
  double rates = 1;     ///< of the angular velocity: rad/s for each rad/s
  double attitude = 0;  ///< of the attitude: rad for each rad/s
};

/// Returns the growth up to each of the ascending times in s since the start, by differences of
/// exact motions. `error` is the size of the initial error in rad/s that matters: where a larger
/// one would not grow in proportion, near the separatrix, the difference is taken at that size.
std::vector<Growth> error_growth(const motion::FreeBody& body, std::span<const double> times,
                                 double error);

}  // namespace twrench::check
