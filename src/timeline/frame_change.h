#pragma once

#include <Eigen/Core>

#include "scene/reference_frame.h"

namespace twrench::timeline {

/// The change of a camera from one frame of reference to another while it watches one motion. It
/// starts at rest in the first frame and ends at rest in the second, so that the camera is seen to
/// spin up or to stop. About L it turns by the least angle for which it never turns backwards. The
/// rest, how the body's attitude differs from that of the rotating frame, it turns by the shortest
/// way.
class FrameChange {
 public:
  /// The start or the end of the change.
  struct End {
    scene::Frame frame;
    /// The motion then.
    motion::Sample sample;
    /// Seconds of motion per second of video then.
    double speed;
  };

  /// The change takes `length` seconds of video, more than 0.
  FrameChange(const motion::FreeBody& body, const End& from, const End& to, double length);

  /// Returns the attitude space_from_frame `time` seconds of video after the start. `sample` is the
  /// motion then. Before the start it is that of the first frame, and after the end that of the
  /// second.
  Eigen::Matrix3d attitude(double time, const motion::Sample& sample) const;

 private:
  /// A frame relative to the one that turns steadily about L or, if the frame is at rest in space,
  /// relative to space.
  struct Remainder {
    Eigen::Matrix3d attitude = Eigen::Matrix3d::Identity();
    /// Along the axes of the frame, in rad per second of video.
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  };
  /// The angle about L in rad, and its rate in rad per second of video.
  struct Spin {
    double angle = 0.0, rate = 0.0;
  };

  Remainder remainder_of(const End& end) const;
  Spin spin_of(const End& end) const;
  double angle(double share) const;

  motion::FreeBody body_;
  scene::Frame from_, to_;
  double length_;
  Eigen::Vector3d axis_;  ///< Direction of L; 0 for a body at rest.
  double steady_rate_;    ///< Rate of the rotating frame, in rad per second of motion.
  Remainder first_, last_;
  Spin start_, end_;
  double angle_;              ///< The angle in rad about L by which the camera turns.
  Eigen::Vector3d rotation_;  ///< From first_ to last_: axis times angle.
};

}  // namespace twrench::timeline
