#pragma once

#include <string_view>
#include <vector>

#include "interchange/played_motion.h"

namespace twrench::interchange {

/// Keys between which an animation interpolates. Neighbouring quaternions have a positive dot
/// product.
struct Track {
  std::vector<float> times;      ///< Those of the player's clock, ascending from 0.
  std::vector<float> rotations;  ///< Unit quaternions (x, y, z, w), four numbers per key.
  std::vector<float> lengths;    ///< |omega| over its initial value; empty for an attitude.
};

/// Returns the keys of the attitude up to `end`, a time in the named unit. The interpolation stays
/// within `max_angle` rad of the attitude, as key_times() describes. Throws as key_times() does.
Track attitude_track(const PlayedMotion& motion, double end, double max_angle,
                     std::string_view unit = "s");

/// Returns the keys of an arrow along z that points along omega in space; omega must not be 0. The
/// direction stays within `max_angle` rad of omega's, and the relative error of the length within
/// `max_angle`. Throws as key_times() does.
Track omega_track(const PlayedMotion& motion, double end, double max_angle);

/// Returns the keys of a steady rotation with the angular velocity `omega` in rad/s, which is not
/// 0. Throws as key_times() does.
Track steady_track(const Eigen::Vector3d& omega, double end, double max_angle);

/// Returns the rotation that turns the z axis to `direction`, of any nonzero length.
Eigen::Quaterniond turn_z_to(const Eigen::Vector3d& direction);

}  // namespace twrench::interchange
