#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/diagnostics.h"
#include "motion/exact.h"
#include "motion/trajectory.h"
#include "scene/scene.h"

namespace twrench {

/// One motion of the film, as one method computes it: what of it does not depend on the frame.
struct Take {
  const Method* method;
  StepControl control;
  FreeBody body;
  double initial_energy;      ///< g cm^2/s^2
  std::vector<Sample> whole;  ///< evenly from 0 to the duration, both included, to draw curves by
  std::optional<ExactMotion::Flips>
      flips;                       ///< predicted; nothing where the body does not turn over
  std::vector<double> flip_times;  ///< s, ascending, as the method itself sees them
};

/// What a take shows at one instant.
struct Instant {
  Sample sample;
  Diagnostics diagnostics;
  std::size_t flips = 0;              ///< so far
  std::optional<double> next_flip;    ///< s, predicted
  std::vector<Sample> trail;          ///< the latest trail_length, oldest first; ends with `sample`
  std::vector<Eigen::Matrix3d> blur;  ///< poses while the shutter is open, half the frame's time
};

/// What a frame shows: an instant of each take, in the order of the takes.
struct Moment {
  int frame = 0;
  double film_time = 0.0;  ///< s
  std::vector<Instant> instants;
};

/// s of motion that a trail covers: as the scene says, or what the body takes for some 12 rad.
double trail_length(const Scene& scene);

/// The film's motions, told frame by frame. A moment depends on the scene and its frame's number
/// alone, never on which other frames are asked for.
class Timeline {
 public:
  /// Integrates all that `frames` (ascending numbers) need: one take or, for a comparison, one a
  /// method. Throws as trajectory does.
  Timeline(const Scene& scene, std::vector<int> frames);

  const std::vector<Take>& takes() const { return takes_; }
  std::size_t size() const { return frames_.size(); }

  /// That of the frame with the number frames[index].
  Moment moment(std::size_t index) const;

 private:
  /// The samples of one take: the frames' own, those of their blur, and the trails' grid.
  struct Record {
    std::vector<Sample> frames;
    std::vector<Sample> blur;  ///< scene_.look.motion_blur for each frame
    std::vector<Sample> grid;  ///< at grid_step_ times grid_numbers_
  };

  Record record(const Take& take) const;
  std::vector<Sample> trail(const Record& record, std::size_t index) const;

  Scene scene_;
  std::vector<int> frames_;
  double trail_length_;
  double grid_step_;                        ///< s
  std::vector<std::int64_t> grid_numbers_;  ///< ascending
  std::vector<Take> takes_;
  std::vector<Record> records_;
};

}  // namespace twrench
