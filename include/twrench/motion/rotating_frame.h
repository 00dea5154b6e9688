#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>

namespace twrench::motion {

/// A frame of reference with its origin at the centre of mass, at one time. Vectors are along the
/// frame's own axes.
struct RotatingFrame {
  /// Rotation space_from_frame: its columns are the frame's axes in space.
  Eigen::Matrix3d attitude = Eigen::Matrix3d::Identity();
  /// Angular velocity Omega of the frame in rad/s; 0 for an inertial frame.
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();
  /// dOmega/dt in rad/s^2.
  Eigen::Vector3d alpha = Eigen::Vector3d::Zero();
};

/// Returns the derivative of omega in rad/s^2, body axes. A rigid body obeys Euler's equations, I
/// omega' = I omega x omega; any other body obeys m' = m x omega with m = X^T L. Throws OutOfRange
/// about "omega" or "X" unless that of the sample is finite.
Eigen::Vector3d angular_acceleration(const FreeBody& body, const Sample& sample);

/// Returns the frame that is fixed in the body. Its attitude is a rotation even if that of the
/// sample is not, because its method leaves SO(3). Throws OutOfRange about "X" or "omega" unless
/// those of the sample are finite.
RotatingFrame body_frame(const FreeBody& body, const Sample& sample);

/// Returns the frame that turns about L with the constant Omega = L / I_k, as the body would if it
/// rotated steadily about axis k, the principal axis nearest to L at t = 0. At t = 0 it is aligned
/// with the axes of space. A body in steady rotation is at rest in this frame, and a slow deviation
/// from it appears as a slow motion. The frame is inertial for a body at rest. `t` is in s. Throws
/// OutOfRange about "t" unless it is finite.
RotatingFrame steady_frame(const FreeBody& body, double t);

/// A point mass of the body as it moves in a frame, and the forces on it. Vectors are along the
/// frame's axes; position and its derivatives in cm, cm/s and cm/s^2, forces in dyn = g cm/s^2.
/// Newton's law holds in the frame: centrifugal + coriolis + euler + constraint = mass *
/// acceleration.
struct PointForces {
  Eigen::Vector3d position;      ///< r
  Eigen::Vector3d velocity;      ///< v, in the frame.
  Eigen::Vector3d acceleration;  ///< In the frame.
  Eigen::Vector3d centrifugal;   ///< -m Omega x (Omega x r)
  Eigen::Vector3d coriolis;      ///< -2 m Omega x v
  Eigen::Vector3d euler;         ///< -m Omega' x r
  Eigen::Vector3d constraint;    ///< The force of the rest of the body, which holds the point.
};

/// The forces in a frame on the points of a body at one time.
class FrameForces {
 public:
  /// `sample` is the state of `body` at the time of `frame`. Throws OutOfRange about "attitude",
  /// "omega", "alpha" or "X" unless it is finite.
  FrameForces(const RotatingFrame& frame, const FreeBody& body, const Sample& sample);

  /// Returns the forces on a mass in g at a position in body axes, cm. They are linear in the mass
  /// and in the position. Throws OutOfRange about "mass" unless it is finite and not negative, and
  /// about "position" unless it is finite.
  PointForces on(double mass, const Eigen::Vector3d& position) const;

 private:
  Eigen::Matrix3d frame_from_body_;
  RotatingFrame frame_;
  Eigen::Vector3d omega_;  ///< Angular velocity of the body, along the frame's axes, in rad/s.
  Eigen::Vector3d alpha_;  ///< Its derivative in space, along the frame's axes, in rad/s^2.
};

}  // namespace twrench::motion
