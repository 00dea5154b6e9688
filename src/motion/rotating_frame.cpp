#include <twrench/math/so3.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/stability.h>

#include "base/require.h"
#include "math/so3_formulas.h"

namespace twrench::motion {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d angular_acceleration(const FreeBody& body, const Sample& sample) {
  require_finite_entries("omega", sample.omega);
  require_finite_entries("X", sample.X);
  if (!body.is_rigid()) {
    const Vector3d m = sample.X.transpose() * body.momentum(), w = body.rigid_velocity(m);
    const Vector3d m_dot = m.cross(body.turning_rate(m)), w_dot = body.inverse() * m_dot;
    return w_dot + body.energy_loss() * (m_dot.cross(w) + m.cross(w_dot));
  }
  // Computed in principal axes, where differences of moments are accurate. If one moment is much
  // smaller than the others, I omega x omega would lose digits by cancellation.
  const auto& [I, axes] = body.principal();
  const Vector3d w = axes.transpose() * sample.omega;
  return axes * Vector3d((I[1] - I[2]) / I[0] * w[1] * w[2], (I[2] - I[0]) / I[1] * w[2] * w[0],
                         (I[0] - I[1]) / I[2] * w[0] * w[1]);
}

RotatingFrame body_frame(const FreeBody& body, const Sample& sample) {
  const Vector3d alpha = angular_acceleration(body, sample);
  return {so3::Quaternion(sample.X).normalized().toRotationMatrix(), sample.omega, alpha};
}

RotatingFrame steady_frame(const FreeBody& body, double t) {
  require_finite("t", t);
  // The axis of the rotation is L both in space and in the frame.
  const Vector3d omega = Tilt(body).steady_rate() * body.momentum().stableNormalized();
  return {so3::exp(t * omega), omega, Vector3d::Zero()};
}

FrameForces::FrameForces(const RotatingFrame& frame, const FreeBody& body, const Sample& sample)
    : frame_from_body_(frame.attitude.transpose() * sample.X),
      frame_(frame),
      omega_(frame_from_body_ * sample.omega),
      alpha_(frame_from_body_ * angular_acceleration(body, sample)) {
  require_finite_entries("attitude", frame.attitude);
  require_finite_entries("omega", frame.omega);
  require_finite_entries("alpha", frame.alpha);
}

PointForces FrameForces::on(double mass, const Vector3d& position) const {
  require_not_negative("mass", mass);
  require_finite_entries("position", position);
  const auto& [attitude, Omega, Omega_dot] = frame_;
  const Vector3d r = frame_from_body_ * position;
  // The body's angular velocity in the frame is u, with the derivative u' there.
  const Vector3d u = omega_ - Omega;
  const Vector3d u_dot = alpha_ - Omega.cross(omega_) - Omega_dot;
  const Vector3d v = u.cross(r);
  const Vector3d inertial_acceleration = alpha_.cross(r) + omega_.cross(omega_.cross(r));
  return {r,
          v,
          u_dot.cross(r) + u.cross(v),
          -mass * Omega.cross(Omega.cross(r)),
          -2 * mass * Omega.cross(v),
          -mass * Omega_dot.cross(r),
          mass * inertial_acceleration};
}

}  // namespace twrench::motion
