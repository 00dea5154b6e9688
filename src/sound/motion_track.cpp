#include "sound/motion_track.h"

#include <ebur128.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <new>
#include <span>

#include "sound/synthesizer.h"

namespace twrench::sound {
namespace {

struct Destroy {
  void operator()(ebur128_state* state) const { ebur128_destroy(&state); }
};

/// The library fails only if memory is exhausted.
void require_success(int error) {
  if (error != EBUR128_SUCCESS) throw std::bad_alloc();
}

constexpr double target = -16;  // LUFS

/// Amplitude that no sample exceeds: -3 dB. An encoder and the curve between the samples exceed it
/// by less than 2 dB, because the sound has only low frequencies.
constexpr double ceiling = 0.7;

/// Returns the sample with that gain. Amplitudes up to half the ceiling stay as they are; larger
/// ones approach the ceiling.
float limited(double gain, float sample) {
  constexpr double half = ceiling / 2;
  const double louder = gain * sample, size = std::abs(louder);
  if (size <= half) return static_cast<float>(louder);
  return static_cast<float>(std::copysign(half + half * std::tanh((size - half) / half), louder));
}

/// Returns the number of the sample of a channel at that time.
std::size_t sample_at(double time) {
  return static_cast<std::size_t>(std::llround(time * sample_rate));
}

}  // namespace

double loudness(const std::function<void(const Sink&)>& play) {
  const std::unique_ptr<ebur128_state, Destroy> meter(
      ebur128_init(channels, sample_rate, EBUR128_MODE_I));
  if (!meter) throw std::bad_alloc();
  constexpr std::size_t block = 4 * sample_rate / 10;
  std::size_t frames = 0;
  do {
    const std::size_t before = frames;
    play([&](std::span<const float> samples) {
      frames += samples.size() / channels;
      require_success(
          ebur128_add_frames_float(meter.get(), samples.data(), samples.size() / channels));
      return true;
    });
    if (frames == before) break;
  } while (frames < block);
  double result = 0;
  require_success(ebur128_loudness_global(meter.get(), &result));
  return result;
}

MotionTrack::MotionTrack(const scene::Scene& film, const std::atomic<bool>* stop)
    : course_(motion_course(film, stop)), stop_(stop) {
  constexpr double close = 0.3;   // LU
  constexpr int most_trials = 8;  // The limit makes a sound softer than its gain predicts.
  gain_ = first_gain();
  for (int i = 0; i < most_trials && gain_ > 0; ++i) {
    const double error =
        target - loudness([&](const Sink& sink) { play(0, course_.length, sink); });
    if (std::abs(error) < close) return;
    gain_ = std::isfinite(error) ? gain_ * std::pow(10, error / 20) : 0;
  }
}

double MotionTrack::first_gain() const {
  constexpr double medium = 0.1;
  const float fastest = *std::ranges::max_element(course_.speeds);
  const double loudest = std::max(noise_amplitude(fastest), course_.flips.empty() ? 0.0 : 1.0);
  return loudest > 0 ? medium / loudest : 0;
}

void MotionTrack::play(double begin, double end, double gain, const Sink& sink) const {
  Synthesizer synthesizer(course_);
  const std::size_t first = sample_at(begin), last = sample_at(end);
  std::array<float, 8192 * channels> samples;
  for (std::size_t done = 0; done < last && (stop_ == nullptr || !*stop_);) {
    // A piece lies either before `first` or after it.
    const std::size_t left = (done < first ? first : last) - done;
    const std::span piece(samples.data(), channels * std::min(left, samples.size() / channels));
    synthesizer.synthesize(piece);
    done += piece.size() / channels;
    if (done <= first) continue;
    for (float& sample : piece) sample = limited(gain, sample);
    if (!sink(piece)) return;
  }
}

}  // namespace twrench::sound
