#include "sound/motion_course.h"

#include <twrench/body/shape.h>
#include <twrench/motion/stability.h>
#include <twrench/motion/trajectory.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "scene/interior.h"
#include "scene/reference_frame.h"
#include "timeline/film_timeline.h"
#include "timeline/smooth_share.h"
#include "timeline/timeline.h"

namespace twrench::sound {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The number of speeds per second of film, and the largest number of speeds of a film.
constexpr double usual_rate = 100, most_speeds = 1e6;

/// The part of a film that shows one motion at a speed that varies with time.
struct Span {
  const scene::Scene& scene;
  const scene::Shot* shot;  ///< Null in a film without shots.
  double begin, end;        ///< In s of film.
  /// The frame of reference from which the camera moves to that of the scene, if it differs.
  scene::Frame from;

  /// Returns the time of the motion in s.
  double motion_time(double film_time) const {
    // Rounding may place the first time before the beginning.
    const double elapsed = std::max(0.0, film_time - begin);
    return shot == nullptr ? elapsed * scene.film.speed : shot->time_of(elapsed);
  }
  /// Returns the seconds of motion per second of film.
  double speed(double film_time) const {
    return shot == nullptr ? scene.film.speed : shot->speed.at(film_time - begin);
  }
  /// Returns the film time at which the motion reaches `time`, which must be within the span.
  double film_time(double time) const {
    double before = begin, after = end;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
      const double middle = std::midpoint(before, after);
      (motion_time(middle) < time ? before : after) = middle;
    }
    return after;
  }
};

std::vector<Span> spans_of(const scene::Scene& film) {
  const double fps = film.film.fps;
  if (film.shots.empty()) {
    return {{film, nullptr, 0, film.frame_count() / fps, film.camera.frame}};
  }
  const std::vector<int> first = scene::first_frames(film);
  std::vector<Span> spans;
  for (std::size_t i = 0; i < film.shots.size(); ++i) {
    const scene::Frame own = film.shots[i].scene.camera.frame;
    spans.push_back(
        {film.shots[i].scene, &film.shots[i], first[i] / fps, first[i + 1] / fps,
         timeline::changes_frame(film, i) ? film.shots[i - 1].scene.camera.frame : own});
  }
  return spans;
}

/// Returns the matrix M for which w^T M w is the mean square speed of the body's ends, in bounding
/// radii per second, if the body turns with the angular velocity w. The ends are the farthest
/// points along the body's axes.
Matrix3d end_speeds(const scene::Body& body) {
  const std::vector<body::Part> parts = scene::visible_parts(body);
  std::array<Vector3d, 6> ends;
  double radius = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Vector3d direction = (i % 2 == 0 ? 1.0 : -1.0) * Vector3d::Unit(Eigen::Index(i / 2));
    double farthest = -std::numeric_limits<double>::infinity();
    for (const body::Part& part : parts) {
      const Vector3d point =
          part.position +
          part.body_from_part *
              body::support(part.shape, part.body_from_part.transpose() * direction);
      if (point.dot(direction) <= farthest) continue;
      farthest = point.dot(direction);
      ends[i] = point;
    }
    radius = std::max(radius, ends[i].norm());
  }
  Matrix3d sum = Matrix3d::Zero();
  for (const Vector3d& end : ends) {
    const Vector3d r = end / radius;
    sum += r.squaredNorm() * Matrix3d::Identity() - r * r.transpose();
  }
  return sum / double(ends.size());
}

/// The motion of a span that is heard.
const timeline::Solution& heard(const std::vector<timeline::Solution>& solutions) {
  const auto flipping = std::ranges::find_if(
      solutions, [](const timeline::Solution& solution) { return !solution.flip_times.empty(); });
  return flipping == solutions.end() ? solutions.front() : *flipping;
}

/// Returns the angular velocity of the camera in space, in rad per second of film. The camera
/// orbits about the y axis of its frame.
Vector3d camera_rate(const Span& span, const motion::FreeBody& body, const motion::Sample& sample,
                     double film_time) {
  const scene::CameraPath& camera = span.scene.camera;
  const auto frame_rate = [&](scene::Frame frame) -> Vector3d {
    const motion::RotatingFrame turning = scene::reference_frame(frame, body, sample);
    return span.speed(film_time) * (turning.attitude * turning.omega);
  };
  const Matrix3d attitude = scene::reference_frame(camera.frame, body, sample).attitude;
  Vector3d rate = frame_rate(camera.frame);
  if (span.from != camera.frame) {
    const double share = timeline::smooth_share((film_time - span.begin) / span.shot->move);
    rate = (1 - share) * frame_rate(span.from) + share * rate;
  }
  return rate + camera.orbit * attitude.col(1);
}

/// Appends the speeds and the flips of a span. The speeds are those of the film times k / rate
/// before the end of the span.
void append(MotionCourse& course, const Span& span, const std::atomic<bool>* stop) {
  const timeline::Timeline motions(span.scene, std::vector<timeline::FrameTime>(), stop);
  const timeline::Solution& solution = heard(motions.solutions());
  const std::size_t first = course.speeds.size();
  const auto film_time = [&](std::size_t i) { return double(first + i) / course.rate; };
  const double points = std::ceil(span.end * course.rate);
  const std::size_t count = static_cast<std::size_t>(points) - std::min(first, std::size_t(points));
  const Matrix3d M = end_speeds(span.scene.body);
  const motion::Tilt tilt(solution.body);
  const auto time_of = [&](std::size_t i) { return span.motion_time(film_time(i)); };
  const auto add = [&](const motion::Sample& sample) {
    const double time = double(course.speeds.size()) / course.rate;
    const Vector3d w = span.speed(time) * sample.omega -
                       sample.X.transpose() * camera_rate(span, solution.body, sample, time);
    constexpr double fastest = 1e6;
    course.speeds.push_back(
        static_cast<float>(std::min(std::sqrt(std::max(0.0, w.dot(M * w))), fastest)));
    course.leans.push_back(static_cast<float>(tilt.of(sample)));
  };
  if (solution.recording) {
    for (std::size_t i = 0; i < count; ++i) add(solution.recording->motion.at(time_of(i)));
  } else {
    motion::visit_samples(solution.body, *solution.method, solution.control, count, time_of, add);
  }
  const double start = span.motion_time(span.begin), end = span.motion_time(span.end);
  for (const double flip : solution.flip_times) {
    if (flip >= start && flip < end) course.flips.push_back(span.film_time(flip));
  }
}

}  // namespace

MotionCourse motion_course(const scene::Scene& film, const std::atomic<bool>* stop) {
  scene::check_shown_motion(film);
  MotionCourse course;
  course.length = film.frame_count() / film.film.fps;
  course.rate = std::min(usual_rate, most_speeds / course.length);
  for (const Span& span : spans_of(film)) append(course, span, stop);
  return course;
}

}  // namespace twrench::sound
