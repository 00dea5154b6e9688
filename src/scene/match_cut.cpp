#include "scene/match_cut.h"

#include <twrench/math/so3.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/reference_frame.h"

namespace twrench::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the attitude of the body as the camera sees it, `time` seconds of video after the start
/// of the shot.
Matrix3d camera_from_body(const Scene& shot, double time, const motion::FreeBody& body,
                          const motion::Sample& sample) {
  const CameraPath& camera = shot.camera;
  const double azimuth = camera.azimuth + camera.orbit * time;
  return so3::exp(camera.elevation * Vector3d::UnitX()) * so3::exp(-azimuth * Vector3d::UnitY()) *
         reference_frame(camera.frame, body, sample).attitude.transpose() * sample.X;
}

std::vector<motion::Sample> samples_of(const Scene& shot, const motion::FreeBody& body,
                                       const std::vector<double>& times) {
  const motion::Method& method = motion::find_method(shot.motion.method);
  return motion::integrate(body, method, shot.motion.control, times).samples;
}

/// A time at which the distance from the wanted attitude has a minimum.
struct Candidate {
  double time, distance;
};

/// Returns the minimum of the parabola through the distances at the times (i - 1, i, i + 1) * step.
Candidate minimum_near(std::size_t i, double step, const std::vector<double>& distances) {
  const double time = static_cast<double>(i) * step, here = distances[i];
  if (i == 0 || i + 1 == distances.size()) return {time, here};
  const double slope = (distances[i + 1] - distances[i - 1]) / 2;
  const double curvature = distances[i + 1] - 2 * here + distances[i - 1];
  if (!(curvature > 0)) return {time, here};
  const double offset = std::clamp(-slope / curvature, -1.0, 1.0);
  return {time + offset * step, here + (slope + curvature * offset / 2) * offset};
}

}  // namespace

double match_time(const Scene& shot, double duration, const Shot& last) {
  const double length = *last.scene.length;
  const motion::FreeBody ended = free_body(last.scene), body = free_body(shot);
  const Matrix3d wanted = camera_from_body(
      last.scene, length, ended, samples_of(last.scene, ended, {last.time_of(length)}).front());
  constexpr double step_angle = 0.02;            // rad
  constexpr double least = 100, most = 200'000;  // steps
  constexpr double equal = 1e-4;                 // squared distances: half a degree
  const double steps =
      std::clamp(std::ceil(duration * fastest_rate(body) / step_angle), least, most);
  std::vector<double> times, distances;
  for (double i = 0; i <= steps; ++i) times.push_back(duration * i / steps);
  for (const motion::Sample& sample : samples_of(shot, body, times)) {
    distances.push_back((camera_from_body(shot, 0, body, sample) - wanted).squaredNorm());
  }
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const bool falls_before = i == 0 || distances[i - 1] >= distances[i];
    const bool rises_after = i + 1 == distances.size() || distances[i + 1] >= distances[i];
    if (falls_before && rises_after)
      candidates.push_back(minimum_near(i, duration / steps, distances));
  }
  const double nearest = std::ranges::min(candidates, {}, &Candidate::distance).distance;
  const auto found = std::ranges::find_if(
      candidates, [&](const Candidate& other) { return other.distance <= nearest + equal; });
  return std::clamp(found->time, 0.0, duration);
}

}  // namespace twrench::scene
