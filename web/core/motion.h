#pragma once

#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>

namespace twrench::page {

/// A body and its exact motion.
struct Motion {
  motion::FreeBody body;
  motion::ExactMotion exact{body};
  double initial_energy = motion::energy(body.inertia(), body.omega());
  /// Distinguishes it from earlier motions at the same address.
  int serial = ++count;
  static inline int count = 0;
};

}  // namespace twrench::page
