#pragma once

#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "integrated_motion.h"

namespace twrench::page {

/// A body and its motion: in closed form or, if there is none, integrated.
struct Motion {
  explicit Motion(const motion::FreeBody& given) : body(given) {
    if (motion::ExactMotion::covers(body)) {
      exact.emplace(body);
    } else {
      integrated = std::make_unique<IntegratedMotion>(body);
    }
  }

  /// Returns the samples at these times, s.
  std::vector<motion::Sample> at(std::span<const double> times) const {
    if (exact) return exact->at(times, 1);
    std::vector<motion::Sample> samples;
    samples.reserve(times.size());
    for (const double t : times) samples.push_back(integrated->at(t));
    return samples;
  }

  motion::FreeBody body;
  std::optional<motion::ExactMotion> exact;
  std::unique_ptr<IntegratedMotion> integrated;
  double initial_energy = motion::energy(body.inertia(), body.omega());
  /// Distinguishes it from earlier motions at the same address.
  int serial = ++count;
  static inline int count = 0;
};

}  // namespace twrench::page
