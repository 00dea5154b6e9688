#include "scene/natural_times.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "scene/limits.h"
#include "scene/phrase.h"
#include "scene/shown_recording.h"

namespace twrench::scene {
namespace {

/// Rounds to that many significant digits. Returns the double nearest to the decimal number, so
/// that it prints as that number.
double rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  double result = 0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

double within(const limits::Limit& limit, double value, int digits) {
  return rounded(std::clamp(value, limit.low, limit.high), digits);
}

/// Returns the angular speed in rad/s that steps must resolve. A body whose moments differ by more
/// than those of a real body turns far faster in a flip than before it; its speed is greatest or
/// least when the component along the intermediate axis vanishes, and halfway between these times.
double speed_of(const motion::FreeBody& body, const motion::ExactMotion& motion) {
  double fastest = 0;
  if (const auto flips = motion.flips()) {
    for (const double t : {flips->first, flips->first + flips->interval / 2}) {
      if (std::isfinite(t)) fastest = std::max(fastest, motion.at(t).omega.stableNorm());
    }
  }
  const double speed = std::max(body.omega().stableNorm(), fastest / 2);
  return speed > 0 ? speed : 1;
}

/// The same for a body in which something moves. A wheel makes it nutate even if it turns slowly,
/// at up to |h| / sqrt(I1 I2). A step must also be shorter than a turn at FreeBody::fastest_rate(),
/// which is far above the other rates if the least moment is tiny.
double speed_of(const motion::FreeBody& body) {
  const Eigen::Vector3d& I = body.principal().moments;
  const double nutation = body.interior().wheel.stableNorm() / std::sqrt(I[0] * I[1]);
  const double speed = std::max({body.initial_rate().stableNorm(), fastest_rate(body) / 2, nutation,
                                 body.fastest_rate() / 100});
  return speed > 0 ? speed : 1;
}

/// Returns a time in s that shows what happens to a body that turns once in `turn` seconds. A
/// nutation is faster than a turn only with moments that no real body has.
double duration_of(const motion::ExactMotion& motion, double turn) {
  constexpr double most_turns = 1000;
  if (const auto flips = motion.flips(); flips && flips->turns_over()) {
    const bool again = std::isfinite(flips->interval);
    const double three = flips->first + (again ? 2.5 * flips->interval : 16 * turn);
    const double one = flips->first + (again ? 0.5 * flips->interval : 0);
    if (one <= most_turns * turn) return std::min(three, most_turns * turn);
  }
  constexpr double fewest = 16, most = 100;
  const double period = motion.nutation_period().value_or(turn);
  return std::clamp(3 * period, fewest * std::min(turn, period), most * turn);
}

/// The same for a body in which something moves: most of the energy that it can lose is lost after
/// five time constants.
double duration_of(const motion::FreeBody& body, double turn) {
  constexpr double fewest = 16, most = 1000, time_constants = 5;
  const double tau = body.interior().energy_loss_time;
  return std::isfinite(tau) ? std::clamp(time_constants * tau, fewest * turn, most * turn)
                            : fewest * turn;
}

/// Returns the speed in seconds of motion per second of video: a turn, or a longer or shorter time
/// if the video would otherwise be too long or too short.
double film_speed_of(double turn, double duration) {
  constexpr double shortest = 10, longest = 60;  // s of video
  return std::clamp(within(limits::speed, turn, 1), within(limits::speed, duration / longest, 2),
                    within(limits::speed, duration / shortest, 2));
}

/// Replaces the times of a free motion by those of a recorded one. It is shown whole, and in real
/// time if the video then lasts 10 to 30 s.
NaturalTimes times_of_recording(NaturalTimes times, const motion::RecordedMotion& recorded) {
  constexpr double shortest = 10, longest = 30;  // s of video
  times.duration = recorded.duration();
  const double speed = std::clamp(1.0, times.duration / longest, times.duration / shortest);
  times.speed = std::clamp(speed, limits::speed.low, limits::speed.high);
  return times;
}

}  // namespace

NaturalTimes natural_times(const motion::FreeBody& body) {
  constexpr double radians_a_step = 0.01, samples_a_radian = 60;
  std::optional<motion::ExactMotion> exact;
  if (body.is_rigid()) exact.emplace(body);
  const double speed = exact ? speed_of(body, *exact) : speed_of(body);
  const double turn = 2 * std::numbers::pi / speed;
  const double shown = exact ? duration_of(*exact, turn) : duration_of(body, turn);
  const double duration = within(limits::duration, shown, 2);
  return {.step = within(limits::step, radians_a_step / speed, 1),
          .sample_rate = rounded(samples_a_radian * speed, 1),
          .duration = duration,
          .speed = film_speed_of(turn, duration)};
}

NaturalTimes natural_times(const Scene& scene) {
  if (scene.motion.recording) {
    return times_of_recording(natural_times(free_body(scene)), scene.motion.recording->motion);
  }
  std::optional<NaturalTimes> all;
  for (const motion::FreeBody& body : shown_bodies(scene)) {
    const NaturalTimes times = natural_times(body);
    if (!all) all = times;
    all->step = std::min(all->step, times.step);
    all->sample_rate = std::max(all->sample_rate, times.sample_rate);
    if (times.duration <= all->duration) continue;
    all->duration = times.duration;
    all->speed = times.speed;
  }
  return *all;
}

void set_natural_times(Scene& scene) {
  const NaturalTimes times = natural_times(scene);
  if (scene.origins.step == Origin::none) scene.motion.control.step = times.step;
  if (scene.origins.duration == Origin::none) scene.motion.duration = times.duration;
  if (scene.origins.speed == Origin::none) scene.film.speed = times.speed;
  for (Shot& shot : scene.shots) set_natural_times(shot.scene);
}

double sample_rate(const Scene& scene) {
  const double fps = scene.film.fps;
  if (scene.origins.fps == Origin::user) return fps;
  constexpr double coarsest = 0.01, most = 1e6;  // of the natural rate; samples
  const double natural = natural_times(scene).sample_rate;
  const bool suits = fps >= coarsest * natural && fps * scene.motion.duration <= most;
  return scene.origins.fps == Origin::scene && suits ? fps : natural;
}

void replace_body(Scene& scene, Body body) {
  scene.body = std::move(body);
  if (scene.origins.title != Origin::user) {
    scene.title = Phrase("A free rigid body", "Et fritt stivt legeme").in(scene.language);
  }
  for (const auto member : all_origins) {
    Origin& origin = scene.origins.*member;
    if (origin == Origin::scene) origin = Origin::none;
  }
  scene.overlay.trail_point.reset();
  scene.overlay.trail_length.reset();
}

}  // namespace twrench::scene
