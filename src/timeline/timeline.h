#pragma once

#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/shown_recording.h"
#include "timeline/camera_move.h"

namespace twrench::timeline {

/// The times of a frame.
struct FrameTime {
  /// Number of the frame in the video.
  int frame = 0;
  /// Time in the video, or since the start of the shot, in s.
  double video_time = 0.0;
  /// Time of the motion in s.
  double t = 0.0;
  /// Seconds of motion per frame.
  double interval = 0.0;
};

/// Returns the times of these frames of a film of one motion.
std::vector<FrameTime> frame_times(const scene::Film& film, const std::vector<int>& frames);

/// One motion of the video as computed by one method: everything that does not depend on the frame.
struct Solution {
  /// The method that computes the motion.
  const motion::Method* method;
  /// Its step size or tolerance.
  motion::StepControl control;
  /// The body and its initial condition.
  motion::FreeBody body;
  /// Energy at t = 0 in g cm^2/s^2.
  double initial_energy;
  /// Samples evenly spaced from 0 to the duration, both included, for drawing curves.
  std::vector<motion::Sample> whole;
  /// The flips of the exact motion; nothing if the body does not turn over or is not rigid.
  std::optional<motion::ExactMotion::Flips> flips;
  /// The flips of a body with a wheel in the method's own solution in s, up to twice the duration;
  /// or those of a recorded motion.
  std::vector<double> wheel_flips;
  /// Times of the flips in the method's own solution in s, ascending.
  std::vector<double> flip_times;
  /// Distinguishes it from other motions in the same picture: its method, or the axis about which
  /// it starts and the moment of inertia about that axis.
  std::string name = {};
  /// The recorded motion that it is; null if `method` computes it.
  std::shared_ptr<const scene::ShownRecording> recording = nullptr;

  /// Returns the motion at these times in s. Throws as motion::integrate() does.
  std::vector<motion::Sample> samples_at(std::span<const double> times) const;

  /// Returns whether the body turns over.
  bool turns_over() const { return flips || !wheel_flips.empty(); }
};

/// The state of one motion in one frame.
struct SolutionState {
  /// The sample at the frame's time.
  motion::Sample sample;
  /// How far the sample deviates from the conserved quantities.
  motion::Diagnostics diagnostics;
  /// Number of flips so far.
  std::size_t flips = 0;
  /// Predicted time of the next flip in s.
  std::optional<double> next_flip;
  /// Samples of the last trail_length seconds, oldest first, ending with `sample`. Empty unless the
  /// scene shows a path.
  std::vector<motion::Sample> trail;
  /// Samples while the shutter is open, which is half the frame interval.
  std::vector<motion::Sample> blur;
  /// Samples at FrameState::star_times.
  std::vector<motion::Sample> stars;

  /// Returns the age of a sample of the trail at this state, as a fraction of the trail's length in
  /// s: from 0 to 1.
  double trail_age(const motion::Sample& of_trail, double trail_length) const;
};

/// The state of a frame: one instant of each motion, in the order of the motions.
struct FrameState {
  /// Number of the frame in the video.
  int frame = 0;
  /// Time in the video, or since the start of the shot, in s.
  double video_time = 0.0;
  /// Opacity of the caption.
  double caption_opacity = 1.0;
  /// Opacity of the panels, readouts and names.
  double text_opacity = 1.0;
  /// The state of each motion.
  std::vector<SolutionState> solutions;
  /// Times like video_time, oldest first and ending with it, through which the trails of the stars
  /// go; empty if their streaks are those of the shutter.
  std::vector<double> star_times = {};
  /// The move with which the shot starts; null if it has none.
  std::shared_ptr<const CameraMove> move = nullptr;
  /// The time of this frame in the move.
  double move_time = 0.0;
};

/// The flips of a motion up to a time.
struct FlipsSoFar {
  /// Their number.
  int count = 0;
  /// The time in s of the last one; 0 if there is none.
  double last = 0.0;
};

/// Returns the duration in s of motion that the trail covers: the scene's value, or the time in
/// which the body rotates by about 12 rad.
double trail_length(const scene::Scene& scene);

/// Returns the time of the motion in s at a time in the video, or in the shot, in s.
using Clock = std::function<double(double)>;

/// Computes the motions of a video frame by frame. A frame state depends only on the scene and the
/// frame number, not on which other frames are requested.
class Timeline {
 public:
  /// Integrates everything that `frames` (in ascending order of t) need: one motion or, for a
  /// comparison, one per method or initial angular velocity. Another thread can end the integration
  /// through `stop`, as in StepControl; it may be null. `clock` is that of the frames, by default
  /// that of a film of one motion. Throws as motion::integrate() does.
  Timeline(const scene::Scene& scene, std::span<const FrameTime> frames,
           const std::atomic<bool>* stop = nullptr, const Clock& clock = {});

  /// The same for frames of a film of one motion, by their numbers.
  Timeline(const scene::Scene& scene, const std::vector<int>& frames)
      : Timeline(scene, frame_times(scene.film, frames)) {}

  const std::vector<Solution>& solutions() const { return solutions_; }
  std::size_t size() const { return frames_.size(); }

  /// Returns the state of frames[index].
  FrameState frame_state(std::size_t index) const;

  /// Returns the flips up to frames[index], in the first motion that has flips.
  FlipsSoFar flips(std::size_t index) const;

 private:
  /// The samples of one motion: at the frames, for their motion blur, and on the grid of the
  /// trails.
  struct Record {
    std::vector<motion::Sample> frames;
    std::vector<motion::Sample> blur;   ///< Those of frame i end before blur_ends_[i].
    std::vector<motion::Sample> grid;   ///< Samples at grid_step_ times grid_numbers_.
    std::vector<motion::Sample> stars;  ///< Samples at star_times_.
  };

  void add_star_times();
  Record record(const Solution& solution) const;
  std::vector<motion::Sample> trail(const Record& record, std::size_t index) const;
  void add_stars(FrameState& state) const;

  scene::Scene scene_;
  std::vector<FrameTime> frames_;
  double trail_length_;
  double grid_step_;                        ///< Spacing in s.
  std::vector<std::size_t> blur_ends_;      ///< End of each frame's blurred poses; see Record.
  std::vector<std::int64_t> grid_numbers_;  ///< Ascending.
  std::vector<double> star_times_;          ///< Ascending, in s of video.
  Clock clock_;
  std::vector<Solution> solutions_;
  std::vector<Record> records_;
};

}  // namespace twrench::timeline
