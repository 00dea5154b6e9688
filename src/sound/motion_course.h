#pragma once

#include <atomic>
#include <vector>

#include "scene/scene.h"

namespace twrench::sound {

/// The course of a film's motion, as far as it can be heard.
struct MotionCourse {
  /// Length of the film in s.
  double length = 0.0;
  /// Number of `speeds` per second of film.
  double rate = 0.0;
  /// Speeds of the body's ends relative to the camera, evenly spaced from the film's start to its
  /// end: the root of the mean square over the ends, in bounding radii of the body per second of
  /// film. They depend neither on the size of the body nor on the unit of time.
  std::vector<float> speeds;
  /// The angles in rad between L and the nearer end of the principal axis that was nearest to L at
  /// the start, at the same times.
  std::vector<float> leans;
  /// Times of the flips in s of film, ascending.
  std::vector<double> flips;
};

/// Computes the course of the motion that each shot shows; of several motions side by side, the
/// first that flips, otherwise the first. Another thread can end the integration through `stop`,
/// which may be null. Throws as timeline::FilmTimeline does.
MotionCourse motion_course(const scene::Scene& film, const std::atomic<bool>* stop = nullptr);

}  // namespace twrench::sound
