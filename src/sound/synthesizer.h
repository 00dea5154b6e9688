#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sound/motion_course.h"

namespace twrench::sound {

/// Returns the amplitude of the noise at a speed in bounding radii per second of film: from 0 at
/// rest to 1.
double noise_amplitude(double speed);

/// Two filters that pass a band of frequencies, one after the other, with a variable centre. They
/// are state-variable filters (V. Zavalishin, The Art of VA Filter Design, 2012), which stay stable
/// and free of clicks while the centre moves.
class BandFilter {
 public:
  /// The coefficients for a centre f, for which `g` is tan(pi f / sample_rate).
  struct Coefficients {
    explicit Coefficients(double g);
    double a1, a2, a3;
  };
  double filter(double sample, const Coefficients& at);

 private:
  struct Stage {
    double first = 0.0, second = 0.0;
  };
  std::array<Stage, 2> stages_;
};

/// Synthesises the sound of a motion: filtered noise whose loudness and pitch rise with the speed
/// of the body's ends, whose pitch also rises with the lean, and a low, decaying tone that starts
/// at each flip. A body at rest has the quiet tone of a room. Memory use does not depend on the
/// length. The same course always gives the same samples.
class Synthesizer {
 public:
  /// The course must outlive the synthesizer.
  explicit Synthesizer(const MotionCourse& course);

  /// Writes the next samples, left and right alternating.
  void synthesize(std::span<float> samples);

 private:
  /// Loudness and pitch of the noise.
  struct Tone {
    double amplitude, g;
  };
  Tone tone_at(std::size_t index) const;
  Tone next_tone();
  double next_accent();
  double envelope() const;

  const MotionCourse& course_;
  std::uint64_t next_ = 0;   ///< Number of the next sample of a channel.
  std::uint64_t end_;        ///< Number of samples of a channel.
  std::size_t segment_ = 0;  ///< Index of the speed before the next sample.
  Tone before_, after_;      ///< Those of the speeds around the next sample.
  std::array<BandFilter, 2> filters_;
  std::size_t next_flip_ = 0;
  double last_flip_;
  double accent_ = 0.0, accent_before_ = 0.0;  ///< The tone's last two samples.
};

/// Samples per second and channel.
inline constexpr int sample_rate = 48'000;

/// Number of channels: left and right. The samples of both alternate.
inline constexpr int channels = 2;

}  // namespace twrench::sound
