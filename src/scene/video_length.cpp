#include "scene/video_length.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include "base/time_unit.h"
#include "scene/limits.h"
#include "scene/scene_values.h"

namespace twrench::scene {
namespace {

/// Returns the value that follows from the length. Throws InvalidArgument about `what` unless it is
/// within the limit.
double derived(const limits::Limit& limit, double value, const char* name, double length,
               const std::string& what) {
  if (limit.allows(value)) return value;
  throw InvalidArgument(what, fmt::format("is {} s, which makes the {} {:.6g}, but that must be {}",
                                          length, name, value, limit.describe()));
}

/// "96 s", "24 d".
std::string time_text(double seconds) {
  const TimeUnit unit = time_unit(seconds);
  return fmt::format("{:.3g} {}", seconds / unit.length, unit.symbol);
}

}  // namespace

void set_video_length(Scene& scene, double length, Kept kept, const std::string& what) {
  double &duration = scene.motion.duration, &speed = scene.film.speed;
  require_without_shots(scene, what);
  limits::check(limits::shot_length, what, length);
  switch (kept) {
    case Kept::speed:
      duration = derived(limits::duration, speed * length, "duration", length, what);
      break;
    case Kept::duration:
      speed = derived(limits::speed, duration / length, "speed", length, what);
      break;
  }
  scene.origins.duration = scene.origins.speed = Origin::user;
}

std::string describe_video(const Scene& scene) {
  const std::string video = time_text(scene.video_length()) + " of video";
  if (!scene.shots.empty()) {
    const std::size_t count = scene.shots.size();
    return fmt::format("{} shot{}: {}", count, count == 1 ? "" : "s", video);
  }
  const double speed = scene.film.speed;
  return fmt::format("{} of motion, {}: {}", time_text(scene.motion.duration),
                     speed == 1 ? "in real time" : fmt::format("{:.3g} times as fast", speed),
                     video);
}

}  // namespace twrench::scene
