#include "scene/motion_summary.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include "scene/prediction.h"

namespace twrench::scene {
namespace {

/// "1 : 1.36 : 2.18", the principal moments as multiples of the least.
std::string ratio_of_moments(const Eigen::Vector3d& moments) {
  return fmt::format("1 : {:.3g} : {:.3g}", moments[1] / moments[0], moments[2] / moments[0]);
}

/// The rate at which the body turns over, from the exact motion, or what keeps it from being rigid.
std::string flips(const motion::FreeBody& body) {
  if (body.energy_loss() > 0) return "loses energy";
  if (!body.is_rigid()) return "contains a wheel";
  const auto flips = motion::ExactMotion(body).flips();
  if (!flips || !flips->turns_over()) return "does not flip";
  constexpr double day = 86400.0;
  return flips->interval < day ? fmt::format("flips every {:.3g} s", flips->interval)
                               : fmt::format("flips every {:.3g} d", flips->interval / day);
}

}  // namespace

std::string motion_summary(const Scene& scene) {
  const motion::FreeBody body = free_body(scene);
  const motion::Tilt tilt(body);
  return fmt::format("{}; moments {}; {}",
                     prediction(body.principal(), tilt.axis(), tilt.steady_rate()),
                     ratio_of_moments(body.principal().moments), flips(body));
}

}  // namespace twrench::scene
