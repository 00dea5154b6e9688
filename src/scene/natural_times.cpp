#include "scene/natural_times.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "scene/limits.h"

namespace twrench::scene {
namespace {

/// Rounds to so many significant digits. Returns the double that is nearest to the decimal number,
/// so that it prints as that number.
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
/// least where the component along the intermediate axis vanishes and halfway in between.
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

/// Returns a time in s that shows what happens to a body that turns once in `turn` seconds. A
/// nutation is faster only with moments that no real body has.
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

}  // namespace

NaturalTimes natural_times(const motion::FreeBody& body) {
  constexpr double radians_a_step = 0.01, samples_a_radian = 60;
  constexpr double shortest_video = 10, longest_video = 60;  // s
  const motion::ExactMotion motion(body);
  const double speed = speed_of(body, motion);
  const double turn = 2 * std::numbers::pi / speed;
  const double duration = within(limits::duration, duration_of(motion, turn), 2);
  return {
      .step = within(limits::step, radians_a_step / speed, 1),
      .sample_rate = rounded(samples_a_radian * speed, 1),
      .duration = duration,
      .speed = within(limits::speed,
                      std::clamp(turn, duration / longest_video, duration / shortest_video), 1)};
}

NaturalTimes natural_times(const Scene& scene) {
  return natural_times(motion::FreeBody(mass_properties(scene.body).inertia, scene.motion.omega));
}

}  // namespace twrench::scene
