#include "motion/visible_error.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace twrench::motion {

std::string visible_error(const FreeBody& body, const Method& method, const Sample& sample) {
  if (method.exact() || !ExactMotion::covers(body)) return {};
  constexpr double visible = 1;            // Degrees.
  constexpr double unsure = visible / 10;  // The error of X grows as eps |omega| t (docs/exact.md).
  constexpr double degrees = 180 / std::numbers::pi;
  const double turned = body.omega().norm() * std::abs(sample.t);
  if (!(turned * std::numeric_limits<double>::epsilon() * degrees < unsure)) return {};
  // |A - B| = 2 sqrt(2) sin(angle / 2) for rotations in the Frobenius norm.
  const double distance = (sample.X - ExactMotion(body).at(sample.t).X).norm();
  const double sine = std::min(distance / (2 * std::numbers::sqrt2), 1.0);
  const double error = 2 * std::asin(sine) * degrees;
  if (error < visible) return {};
  return fmt::format("{} is off by {:.3g} degrees at {:.6g} s; the method exact is not",
                     method.name, error, sample.t);
}

}  // namespace twrench::motion
