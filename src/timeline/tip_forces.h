#pragma once

#include <twrench/motion/free_body.h>
#include <twrench/motion/stability.h>

#include <Eigen/Core>

namespace twrench::timeline {

/// The forces in the rotating frame (motion::steady_frame) on a body, as two forces on the tip of a
/// principal axis: at the tip, they have the same torques perpendicular to this axis as the
/// centrifugal and the Coriolis forces on the whole body.
class TipForces {
 public:
  explicit TipForces(const motion::FreeBody& body);

  /// Returns the end of the principal axis that is nearest to L at t = 0, a unit vector in body
  /// axes.
  const Eigen::Vector3d& axis() const { return axis_; }

  /// Forces on a tip 1 cm from the centre of mass, in dyn, body axes. Both are perpendicular to the
  /// axis. On a tip at another distance, they are inversely proportional to it.
  struct Forces {
    Eigen::Vector3d centrifugal, coriolis;
  };
  Forces at(const motion::Sample& sample) const;

 private:
  motion::FreeBody body_;
  double rate_;  ///< Angular speed of the frame in rad/s.
  Eigen::Vector3d axis_;
};

}  // namespace twrench::timeline
