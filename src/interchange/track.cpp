#include "interchange/track.h"

#include <twrench/body/shape.h>

#include "interchange/key_times.h"
#include "math/rotation_between.h"

namespace twrench::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

void append_rotation(Track& track, const Quaterniond& q) {
  for (const double number : q.coeffs()) track.rotations.push_back(static_cast<float>(number));
}

}  // namespace

Track attitude_track(const PlayedMotion& motion, double end, double max_angle,
                     std::string_view unit) {
  Track track;
  track.times = key_times(
      end, max_angle, [&](double from, double to) { return motion.attitude_rates(from, to); },
      unit);
  Quaterniond last = Quaterniond::Identity();
  for (const float time : track.times) {
    Quaterniond q(motion.at(time).X);
    if (q.dot(last) < 0) q.coeffs() = -q.coeffs();
    append_rotation(track, q);
    last = q;
  }
  return track;
}

/// Between two keys the arrow turns by the shortest way, so that it stays on the great circle
/// through both.
Track omega_track(const PlayedMotion& motion, double end, double max_angle) {
  Track track;
  track.times = key_times(end, max_angle,
                          [&](double from, double to) { return motion.omega_rates(from, to); });
  const Vector3d initial = motion.at(0).omega;
  Quaterniond q = turn_z_to(initial);
  for (const float time : track.times) {
    const motion::Sample sample = motion.at(time);
    const double rate = sample.omega.stableNorm();
    const Vector3d direction = sample.X * (sample.omega / rate);
    q = (so3::rotation_between(q * Vector3d::UnitZ(), direction) * q).normalized();
    append_rotation(track, q);
    track.lengths.push_back(static_cast<float>(rate / initial.stableNorm()));
  }
  return track;
}

Track steady_track(const Vector3d& omega, double end, double max_angle) {
  Track track;
  const double rate = omega.norm();
  track.times = key_times(end, max_angle, [&](double, double) { return RateBounds{rate, 0}; });
  for (const float time : track.times) {
    append_rotation(track, Quaterniond(Eigen::AngleAxisd(rate * time, omega / rate)));
  }
  return track;
}

Quaterniond turn_z_to(const Vector3d& direction) {
  return Quaterniond(body::frame_with_z_along(direction));
}

}  // namespace twrench::interchange
