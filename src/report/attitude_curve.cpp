#include "report/attitude_curve.h"

#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include "report/solution.h"
#include "study/reference.h"

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
  if (body.energy_loss() > 0) return curve;
  const auto flips = body.is_rigid() ? motion::ExactMotion(body).flips() : std::nullopt;
  if (!body.is_rigid() || (flips && flips->turns_over())) {
    curve.flips = study::reference_flip_times(body, scene.motion.duration);
  }
  return curve;
}

}  // namespace twrench::report
