#include "report/attitude_curve.h"

#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include "motion/reference_motion.h"
#include "report/solution.h"
#include "scene/shown_recording.h"
#include "study/reference.h"

namespace twrench::report {

namespace {

constexpr double most_times = 20'000;

}  // namespace

plot::AttitudeCurve attitude_curve(const scene::Scene& scene) {
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

std::vector<plot::AttitudeCurve> shown_curves(const scene::Scene& scene) {
  const auto& recording = scene.motion.recording;
  if (!recording) return {attitude_curve(scene)};
  std::vector<plot::AttitudeCurve> curves{
      {scene.shown_title(), recording->motion.samples_at(plot_times(scene.motion, most_times)),
       recording->flip_times}};
  if (!recording->has_body) return curves;
  scene::Scene exact = scene;
  const motion::Method& method = motion::reference_method(scene::free_body(scene));
  exact.motion.method = method.name;
  exact.motion.control = motion::reference_control(scene.motion.control.stop);
  exact.title = method.name;
  curves.push_back(attitude_curve(exact));
  curves.back().is_dashed = true;
  return curves;
}

}  // namespace twrench::report
