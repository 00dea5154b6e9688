#include "timeline/tip_forces.h"

#include <Eigen/Geometry>

namespace twrench::timeline {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TipForces::TipForces(const motion::FreeBody& body) : body_(body) {
  const motion::Tilt tilt(body);
  rate_ = tilt.steady_rate();
  axis_ = body.principal().axes.col(tilt.axis());
  if (axis_.dot(body.inertia() * body.omega()) < 0) axis_ = -axis_;
}

/// With S = tr(I)/2 - I, the integral of r r^T dm, the frame's angular velocity f and the body's w
/// relative to it, the torques are f x S f and 2 w x S f. A force F at the tip a has the torque
/// a x F, which equals the part of a torque T perpendicular to a if F = T x a.
TipForces::Forces TipForces::at(const motion::Sample& sample) const {
  const Matrix3d& I = body_.inertia();
  const Vector3d f = rate_ * (I * sample.omega).stableNormalized();
  const Vector3d Sf = 0.5 * I.trace() * f - I * f;
  return {f.cross(Sf).cross(axis_), 2 * (sample.omega - f).cross(Sf).cross(axis_)};
}

}  // namespace twrench::timeline
