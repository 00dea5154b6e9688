#pragma once

#include <atomic>
#include <functional>
#include <span>

#include "scene/scene.h"
#include "sound/motion_course.h"

namespace twrench::sound {

/// Receives samples, left and right alternating. Returns whether it takes more.
using Sink = std::function<bool(std::span<const float>)>;

/// Returns the integrated loudness of a sound in LUFS (ITU-R BS.1770), which `play` passes to its
/// argument in pieces; -infinity if it is silent. A sound too short to have a loudness, less than
/// 0.4 s, is repeated.
double loudness(const std::function<void(const Sink&)>& play);

/// The sound of a film's motion: 48 kHz, stereo, with an integrated loudness of -16 LUFS and true
/// peaks below -1 dB, or silence if nothing moves. It is synthesised again whenever it is needed
/// instead of being stored.
class MotionTrack {
 public:
  /// Computes the motion and the loudness. Throws as motion_course() does.
  explicit MotionTrack(const scene::Scene& film, const std::atomic<bool>* stop = nullptr);

  /// Passes the samples of the film from `begin` to `end`, in s of film, to `sink`.
  void play(double begin, double end, const Sink& sink) const { play(begin, end, gain_, sink); }

 private:
  void play(double begin, double end, double gain, const Sink& sink) const;
  /// Returns a gain for which the loudest part has a medium loudness; 0 if nothing moves.
  double first_gain() const;

  MotionCourse course_;
  const std::atomic<bool>* stop_;
  double gain_ = 0.0;  ///< 0 if the film is silent.
};

}  // namespace twrench::sound
