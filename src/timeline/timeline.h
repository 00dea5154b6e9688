#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/diagnostics.h"
#include "motion/exact.h"
#include "motion/trajectory.h"
#include "scene/scene.h"

namespace twrench {

/// One motion of the video as computed by one method: everything that does not depend on the frame.
struct Take {
  /// The method that computes the motion.
  const Method* method;
  /// Its step size or tolerance.
  StepControl control;
  /// The body and its initial condition.
  FreeBody body;
  /// Energy at t = 0 in g cm^2/s^2.
  double initial_energy;
  /// Samples evenly spaced from 0 to the duration, both included, for drawing curves.
  std::vector<Sample> whole;
  /// The flips of the exact motion; nothing if the body does not turn over.
  std::optional<ExactMotion::Flips> flips;
  /// Times of the flips in the method's own solution in s, ascending.
  std::vector<double> flip_times;
};

/// The state of one motion in one frame.
struct Instant {
  /// The sample at the frame's time.
  Sample sample;
  /// How far the sample deviates from the conserved quantities.
  Diagnostics diagnostics;
  /// Number of flips so far.
  std::size_t flips = 0;
  /// Predicted time of the next flip in s.
  std::optional<double> next_flip;
  /// Samples of the last trail_length seconds, oldest first, ending with `sample`.
  std::vector<Sample> trail;
  /// Poses while the shutter is open, which is half the frame interval.
  std::vector<Eigen::Matrix3d> blur;
};

/// The frame state: one instant of each motion, in the order of the motions.
struct Moment {
  /// Number of the frame in the video.
  int frame = 0;
  /// Time in the video in s.
  double film_time = 0.0;
  /// The state of each motion.
  std::vector<Instant> instants;
};

/// Returns the duration in s of motion that the trail covers: the scene's value, or the time in
/// which the body rotates by about 12 rad.
double trail_length(const Scene& scene);

/// Computes the motions of a video frame by frame. A frame state depends only on the scene and the
/// frame number, not on which other frames are requested.
class Timeline {
 public:
  /// Integrates everything that `frames` (ascending numbers) need: one motion or, for a comparison,
  /// one per method. Throws as trajectory() does.
  Timeline(const Scene& scene, std::vector<int> frames);

  const std::vector<Take>& takes() const { return takes_; }
  std::size_t size() const { return frames_.size(); }

  /// Returns the state of the frame with number frames[index].
  Moment moment(std::size_t index) const;

 private:
  /// The samples of one motion: at the frames, for their motion blur, and on the grid of the
  /// trails.
  struct Record {
    std::vector<Sample> frames;
    std::vector<Sample> blur;  ///< scene_.look.motion_blur samples per frame.
    std::vector<Sample> grid;  ///< Samples at grid_step_ times grid_numbers_.
  };

  Record record(const Take& take) const;
  std::vector<Sample> trail(const Record& record, std::size_t index) const;

  Scene scene_;
  std::vector<int> frames_;
  double trail_length_;
  double grid_step_;                        ///< Spacing in s.
  std::vector<std::int64_t> grid_numbers_;  ///< Ascending.
  std::vector<Take> takes_;
  std::vector<Record> records_;
};

}  // namespace twrench
