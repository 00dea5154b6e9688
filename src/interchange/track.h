#pragma once

#include <vector>

#include "interchange/played_motion.h"

namespace twrench::interchange {

/// Keys between which an animation interpolates. Neighbouring quaternions have a positive dot
/// product.
struct Track {
  std::vector<float> times;      ///< s, ascending from 0.
  std::vector<float> rotations;  ///< Unit quaternions (x, y, z, w), four numbers a key.
  std::vector<float> lengths;    ///< |omega| over its initial value; empty for an attitude.
};

/// Returns the keys of the attitude up to `end` s, which keep within `max_angle` rad of it, as
/// key_times() describes. Throws as key_times().
Track attitude_track(const PlayedMotion& motion, double end, double max_angle);

/// Returns the keys of an arrow along z that points along omega, which must not be 0, in space:
/// its direction keeps within `max_angle` rad of omega's, its length within `max_angle` times
/// itself. Throws as key_times().
Track omega_track(const PlayedMotion& motion, double end, double max_angle);

/// Returns the keys of a steady rotation with the angular velocity `omega` in rad/s, which is not
/// 0. Throws as key_times().
Track steady_track(const Eigen::Vector3d& omega, double end, double max_angle);

/// Returns the rotation that turns the z axis to `direction`, of any nonzero length.
Eigen::Quaterniond turn_z_to(const Eigen::Vector3d& direction);

}  // namespace twrench::interchange
