#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "timeline/timeline.h"

namespace twrench::timeline {

/// A frame of a film: one instant of a shot and, during the transition from the previous shot, of
/// that shot too.
struct FilmFrame {
  /// Index of the shot; 0 in a film without shots.
  std::size_t shot = 0;
  /// The state in that shot.
  FrameState state;
  /// The state in the previous shot, while that is visible or the camera still moves away from it.
  std::optional<FrameState> previous;
  /// Opacity of the shot over the previous one, 0 to 1.
  double faded = 1.0;
  /// How far the camera has moved from the previous shot's view to this shot's, 0 to 1.
  double moved = 1.0;
};

/// Returns the scene of the shot with that index: the film itself, if it has no shots.
const scene::Scene& scene_of_shot(const scene::Scene& film, std::size_t shot);

/// Returns whether the camera of a shot moves from another frame of reference while the motion of
/// the previous shot goes on.
bool changes_frame(const scene::Scene& film, std::size_t shot);

/// Returns the time in s of the motion that each frame of the film shows.
std::vector<double> motion_times(const scene::Scene& film);

/// Computes the motions of a film frame by frame, whether it has shots or not. A frame depends only
/// on the film and the frame's number, not on which other frames are requested.
class FilmTimeline {
 public:
  /// Integrates everything that `frames` (ascending numbers) need. Another thread can end the
  /// integration through `stop`, as in StepControl; it may be null. Throws as motion::integrate()
  /// does, and InvalidArgument as check_shown_motion() does.
  FilmTimeline(const scene::Scene& film, const std::vector<int>& frames,
               const std::atomic<bool>* stop = nullptr);

  std::size_t size() const { return frames_.size(); }

  /// Returns the frame with number frames[index].
  FilmFrame frame(std::size_t index) const;

  /// Returns the index of the shot to which that frame belongs; 0 in a film without shots.
  std::size_t shot(std::size_t index) const { return frames_[index].own.shot; }

  /// Returns the flips up to the frame with number frames[index], in the first motion of its shot
  /// that has flips.
  FlipsSoFar flips(std::size_t index) const {
    const Place& own = frames_[index].own;
    return timelines_.at(own.shot).flips(own.index);
  }

  /// Returns the motions of a shot that at least one of the frames shows.
  const std::vector<Solution>& solutions(std::size_t shot) const {
    return timelines_.at(shot).solutions();
  }

 private:
  /// A frame's place in a timeline.
  struct Place {
    std::size_t shot, index;
  };
  struct Frame {
    Place own;
    std::optional<Place> previous;
    double faded, moved;
  };

  std::shared_ptr<const CameraMove> move_of(const scene::Scene& film, std::size_t shot) const;

  std::vector<Frame> frames_;
  std::map<std::size_t, Timeline> timelines_;  ///< By the index of the shot.
  /// By the index of the shot; only of shots that start with a move.
  std::map<std::size_t, std::shared_ptr<const CameraMove>> moves_;
  /// The end of a shot, and whether its text fades out before it.
  struct TextEnd {
    double time;          ///< The end of the shot, in s.
    bool caption_leaves;  ///< Whether the next shot has another caption.
    bool text_leaves;     ///< Whether the next shot fades in with other text.
  };
  void fade_text(std::size_t shot, FrameState& state) const;

  std::vector<TextEnd> text_ends_;   ///< For each shot but the last.
  std::optional<double> text_fade_;  ///< That of the film, in s.
};

}  // namespace twrench::timeline
