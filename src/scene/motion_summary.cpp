#include "scene/motion_summary.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <cmath>

#include "base/time_unit.h"
#include "scene/prediction.h"

namespace twrench::scene {
namespace {

/// "1 : 1.36 : 2.18", the principal moments as multiples of the least.
std::string ratio_of_moments(const Eigen::Vector3d& moments) {
  return fmt::format("1 : {:.3g} : {:.3g}", moments[1] / moments[0], moments[2] / moments[0]);
}

/// The rate at which the body turns over, from the exact motion.
std::string flips(const motion::FreeBody& body) {
  const auto flips = motion::ExactMotion(body).flips();
  if (!flips || !flips->turns_over()) return "does not flip";
  constexpr double day = 86400.0;
  return flips->interval < day ? fmt::format("flips every {:.3g} s", flips->interval)
                               : fmt::format("flips every {:.3g} d", flips->interval / day);
}

/// "with a wheel of 6e+03 g cm^2/s; loses energy within 50 s".
std::string interior(const motion::Interior& interior) {
  std::string text;
  const double wheel = interior.wheel.stableNorm(), tau = interior.energy_loss_time;
  if (wheel > 0) text = fmt::format("with a wheel of {:.4g} g cm^2/s", wheel);
  if (std::isfinite(tau)) {
    const TimeUnit unit = time_unit(tau);
    text += fmt::format("{}loses energy within {:.3g} {}", wheel > 0 ? "; " : "", tau / unit.length,
                        unit.symbol);
  }
  return text;
}

}  // namespace

std::string motion_summary(const Scene& scene) {
  const motion::FreeBody body = free_body(scene);
  if (!body.is_rigid()) {
    return fmt::format("{}; moments {}", interior(body.interior()),
                       ratio_of_moments(body.principal().moments));
  }
  const motion::Tilt tilt(body);
  return fmt::format("{}; moments {}; {}",
                     prediction(body.principal(), tilt.axis(), tilt.steady_rate()),
                     ratio_of_moments(body.principal().moments), flips(body));
}

}  // namespace twrench::scene
