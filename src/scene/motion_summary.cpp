#include "scene/motion_summary.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/polhode.h>
#include <twrench/motion/stability.h>

#include <cmath>

#include "base/time_unit.h"
#include "scene/prediction.h"

namespace twrench::scene {
namespace {

/// "1 : 1.36 : 2.18", the principal moments as multiples of the least.
std::string ratio_of_moments(const Eigen::Vector3d& moments) {
  return fmt::format("1 : {:.3g} : {:.3g}", moments[1] / moments[0], moments[2] / moments[0]);
}

/// "23.6 s" or "2.71 d".
std::string in_seconds_or_days(double time) {
  constexpr double day = 86400.0;
  return time < day ? fmt::format("{:.3g} s", time) : fmt::format("{:.3g} d", time / day);
}

/// The rate at which the body turns over, from the exact motion.
std::string flips(const motion::ExactMotion& motion) {
  const auto flips = motion.flips();
  if (!flips || !flips->turns_over()) return "does not flip";
  return "flips every " + in_seconds_or_days(flips->interval);
}

/// The effect of a small tilt. If the tilt is so large that a body which starts nearest to its
/// intermediate axis does not turn over, it wobbles about an outer axis instead.
std::string effect_of_tilt(const motion::FreeBody& body, const motion::ExactMotion& motion) {
  const motion::Tilt tilt(body);
  const body::PrincipalAxes& principal = body.principal();
  const auto flips = motion.flips();
  if (tilt.axis() == body::PrincipalAxes::intermediate && flips && !flips->turns_over()) {
    const Eigen::Vector3d direction =
        principal.axes.transpose() * body.body_momentum().stableNormalized();
    const int axis = motion::level_through(principal.moments, direction)->axis;
    return fmt::format("wobbles about {} every {}", axis_name(principal.axes, axis),
                       in_seconds_or_days(*motion.nutation_period()));
  }
  return prediction(principal, tilt.axis(), tilt.steady_rate());
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
  const motion::ExactMotion motion(body);
  return fmt::format("{}; moments {}; {}", effect_of_tilt(body, motion),
                     ratio_of_moments(body.principal().moments), flips(motion));
}

}  // namespace twrench::scene
