#include "report/attitude_curve.h"

#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include "report/solution.h"

namespace twrench::report {

plot::AttitudeCurve attitude_curve(const scene::Scene& scene) {
  constexpr double most_times = 20'000;
  const motion::FreeBody body = scene::free_body(scene);
  const motion::Method& method = motion::find_method(scene.motion.method);
  plot::AttitudeCurve curve;
  curve.title = scene.shown_title();
  curve.samples =
      motion::integrate(body, method, scene.motion.control, plot_times(scene.motion, most_times))
          .samples;
  if (!body.is_rigid()) return curve;
  const motion::ExactMotion motion(body);
  const auto flips = motion.flips();
  if (flips && flips->turns_over()) curve.flips = motion.flip_times(scene.motion.duration);
  return curve;
}

}  // namespace twrench::report
