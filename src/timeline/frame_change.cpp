#include "timeline/frame_change.h"

#include <twrench/math/so3.h>
#include <twrench/motion/stability.h>

#include <cmath>
#include <numbers>

#include "timeline/smooth_share.h"

namespace twrench::timeline {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the least angle that is at least `least` and differs from `angle` by whole turns.
double next_angle(double least, double angle) {
  constexpr double turn = 2 * std::numbers::pi, round_off = 1e-6;
  const double from = least - round_off;
  return angle + turn * std::ceil((from - angle) / turn);
}

}  // namespace

FrameChange::FrameChange(const motion::FreeBody& body, const End& from, const End& to,
                         double length)
    : body_(body),
      from_(from.frame),
      to_(to.frame),
      length_(length),
      axis_(body.momentum().stableNormalized()),
      steady_rate_(motion::Tilt(body).steady_rate()),
      first_(remainder_of(from)),
      last_(remainder_of(to)),
      start_(spin_of(from)),
      end_(spin_of(to)),
      // With this least angle the rate of angle() is nowhere negative.
      angle_(next_angle(0.4 * (start_.rate + end_.rate) * length, end_.angle - start_.angle)),
      rotation_(so3::log(first_.attitude.transpose() * last_.attitude)) {}

FrameChange::Remainder FrameChange::remainder_of(const End& end) const {
  if (end.frame != scene::Frame::body) return {};
  const Vector3d steady = steady_rate_ * axis_;
  const Matrix3d attitude = so3::exp(-end.sample.t * steady) *
                            scene::reference_frame(end.frame, body_, end.sample).attitude;
  return {attitude, end.speed * (end.sample.omega - attitude.transpose() * steady)};
}

FrameChange::Spin FrameChange::spin_of(const End& end) const {
  if (end.frame == scene::Frame::space) return {};
  return {steady_rate_ * end.sample.t, steady_rate_ * end.speed};
}

/// Its rate goes smoothly from that at the start to that at the end, without acceleration at either
/// end, plus what the angle requires in between.
double FrameChange::angle(double share) const {
  const double s2 = share * share, s3 = s2 * share, s4 = s3 * share;
  const double rise = s3 - s4 / 2;  // the integral of smooth_share()
  const double missing = 30 * (angle_ - (start_.rate + end_.rate) / 2 * length_);
  return start_.angle + length_ * (start_.rate * (share - rise) + end_.rate * rise) +
         missing * (s3 / 3 - s4 / 2 + s4 * share / 5);
}

Matrix3d FrameChange::attitude(double time, const motion::Sample& sample) const {
  if (time <= 0) return scene::reference_frame(from_, body_, sample).attitude;
  if (time >= length_) return scene::reference_frame(to_, body_, sample).attitude;
  const double s = time / length_;
  const bool both_turn = from_ != scene::Frame::space && to_ != scene::Frame::space;
  const double about_momentum = both_turn ? steady_rate_ * sample.t : angle(s);
  // A cubic Hermite spline on SO(3): the factors have the velocities of both ends.
  return so3::exp(about_momentum * axis_) * first_.attitude *
         so3::exp(s * (1 - s) * (1 - s) * length_ * first_.velocity) *
         so3::exp(smooth_share(s) * rotation_) *
         so3::exp(s * s * (s - 1) * length_ * last_.velocity);
}

}  // namespace twrench::timeline
