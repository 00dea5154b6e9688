#pragma once

#include <twrench/motion/free_body.h>

#include <span>
#include <vector>

namespace twrench::check {

/// The largest growth of a small error of the initial angular velocity up to some time, over all
/// directions of the error.
struct Growth {
  double rates = 1;     ///< of the angular velocity: rad/s for each rad/s
  double attitude = 0;  ///< of the attitude: rad for each rad/s
};

/// Returns the growth up to each of the ascending `times`, in s since the start, from differences
/// of exact motions. `error` is the size in rad/s of the initial error of interest. Near the
/// separatrix, where larger errors would not grow in proportion, the differences are taken over
/// that size.
std::vector<Growth> error_growth(const motion::FreeBody& body, std::span<const double> times,
                                 double error);

}  // namespace twrench::check
