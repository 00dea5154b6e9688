#include "motion/phase.h"

#include <twrench/math/so3.h>
#include <twrench/motion/propagator.h>
#include <twrench/motion/stepper.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "motion/reference_motion.h"
#include "motion/root.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Returns the area of a triangle on the unit sphere, positive if its corners are counterclockwise
/// seen from outside (Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983)).
double triangle_area(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// Follows the momentum of a body without a closed form around its path.
class PathOfMomentum {
 public:
  explicit PathOfMomentum(const FreeBody& body)
      : body_(body),
        axis_(body.momentum().stableNormalized()),
        start_(direction(body.attitude())),
        velocity_(start_.cross(body.initial_rate())) {}

  std::optional<ExactMotion::Phase> phase() {
    constexpr double steady = 1e-12;
    if (!(velocity_.norm() > steady * body_.fastest_rate())) return std::nullopt;
    constexpr int most_of_path = 20'000;
    const auto propagator = make_propagator(body_, method_, reference_control());
    for (int i = 0; i < most_of_path; ++i) {
      const AcceptedStep step = propagator->next_step();
      const std::optional<double> end = return_in(step);
      add(step, end.value_or(step.length));
      if (end) return phase_at(step.t + *end, attitude(step, *end));
    }
    return std::nullopt;
  }

 private:
  Vector3d direction(const Matrix3d& X) const { return X.transpose() * axis_; }

  Matrix3d attitude(const AcceptedStep& step, double length) const {
    return take_step(body_, method_, step.before, length).X;
  }

  /// Positive on the side of the start to which the momentum moves.
  double ahead(const Matrix3d& X) const { return velocity_.dot(direction(X)); }

  /// Returns the time after the beginning of the step at which the momentum is back at its start.
  std::optional<double> return_in(const AcceptedStep& step) const {
    const double before = ahead(step.before), after = ahead(step.after);
    if (step.t == 0 || !(before < 0) || after < 0) return std::nullopt;
    const auto at = [&](double length) { return ahead(attitude(step, length)); };
    const double length = root_within(at, step.length, before, after);
    // The path may cross the plane elsewhere. Near a saddle it is slow, and has another branch
    // near.
    constexpr double near = 1e-3;
    const double distance = (direction(attitude(step, length)) - start_).norm();
    if (distance > near * velocity_.norm() / body_.fastest_rate()) return std::nullopt;
    return length;
  }

  /// Adds the part of a step to the dynamic angle, the integral of omega . m/|m|, and to the area.
  void add(const AcceptedStep& step, double length) {
    const auto rate = [&](double h) {
      const Matrix3d X = attitude(step, h);
      return angular_velocity(body_, method_, X).dot(direction(X));
    };
    // The series of a step converges so fast that ten nodes integrate it to round-off.
    dynamic_ += boost::math::quadrature::gauss<double, 10>::integrate(rate, 0.0, length);
    constexpr int chords = 4;
    Vector3d last = direction(step.before);
    for (int i = 1; i <= chords; ++i) {
      const Vector3d next = direction(attitude(step, length * i / chords));
      area_ += triangle_area(start_, last, next);
      last = next;
    }
  }

  /// The attitude at the end determines the area modulo 2 pi, and its sum the multiple of 2 pi.
  ExactMotion::Phase phase_at(double period, const Matrix3d& X) const {
    const double turn = so3::log(X * body_.attitude().transpose()).dot(axis_);
    const double about = std::remainder(area_, 4 * pi);
    const double area = about + std::remainder(dynamic_ - turn - about, 2 * pi);
    return {.period = period, .total = dynamic_ - area, .dynamic = dynamic_};
  }

  const FreeBody& body_;
  const Method& method_ = find_method("taylor");
  Vector3d axis_;      ///< L/|L| in space.
  Vector3d start_;     ///< Direction of the momentum in the body at t = 0.
  Vector3d velocity_;  ///< Its derivative, 1/s.
  double dynamic_ = 0, area_ = 0;
};

}  // namespace

std::optional<ExactMotion::Phase> phase_of(const FreeBody& body) {
  if (ExactMotion::covers(body)) return ExactMotion(body).phase();
  if (body.energy_loss() > 0) return std::nullopt;
  return PathOfMomentum(body).phase();
}

}  // namespace twrench::motion
