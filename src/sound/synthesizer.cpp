#include "sound/synthesizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace twrench::sound {
namespace {

constexpr double pi = std::numbers::pi;

/// The noise has half of its greatest amplitude at a turn per second.
constexpr double medium_speed = 2 * pi;
/// Hz. At rest the noise would have the lowest pitch; at a turn per second about 690 Hz. It is up
/// to an octave higher while the body leans, so that a flip is heard to come.
constexpr double lowest_pitch = 140, highest_pitch = 3000;
constexpr double pitch_exponent = 0.8;

/// The least amplitude of the noise in a film in which something moves: the tone of the room, which
/// is heard where the camera turns with the body.
constexpr double room_amplitude = 0.03;

/// Each filter's ratio of centre to bandwidth.
constexpr double quality = 0.7;

/// The tone of a flip: Hz, s, and its amplitude relative to the greatest of the noise.
constexpr double accent_pitch = 75, accent_decay = 0.14, accent_amplitude = 1.2;
/// s. Flips that follow each other faster share a tone.
constexpr double accent_spacing = 0.02;

/// s. At its start and its end the sound fades, so that neither clicks.
constexpr double edge = 0.03;

/// Returns a well-mixed number for each counter: SplitMix64 (G. L. Steele, D. Lea and C. H. Flood,
/// Fast splittable pseudorandom number generators, 2014).
std::uint64_t mixed(std::uint64_t counter) {
  std::uint64_t z = (counter + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// Returns a number from -1 to 1.
double signed_unit(std::uint64_t bits) {
  return static_cast<double>(static_cast<std::int32_t>(static_cast<std::uint32_t>(bits))) * 0x1p-31;
}

/// The factors of the recurrence y[n] = a y[n-1] - b y[n-2], whose solutions are decaying sines.
struct Decay {
  double a, b;
};
const Decay accent_recurrence = [] {
  const double decay = std::exp(-1 / (accent_decay * sample_rate));
  return Decay{2 * decay * std::cos(2 * pi * accent_pitch / sample_rate), decay * decay};
}();

}  // namespace

double noise_amplitude(double speed) { return speed / (speed + medium_speed); }

BandFilter::Coefficients::Coefficients(double g)
    : a1(1 / (1 + g * (g + 1 / quality))), a2(g * a1), a3(g * a2) {}

double BandFilter::filter(double sample, const Coefficients& at) {
  for (Stage& stage : stages_) {
    const double rest = sample - stage.second;
    const double band = at.a1 * stage.first + at.a2 * rest;
    const double low = stage.second + at.a2 * stage.first + at.a3 * rest;
    stage.first = 2 * band - stage.first;
    stage.second = 2 * low - stage.second;
    sample = band / quality;
  }
  return sample;
}

Synthesizer::Synthesizer(const MotionCourse& course)
    : course_(course),
      end_(static_cast<std::uint64_t>(std::llround(course.length * sample_rate))),
      before_(tone_at(0)),
      after_(tone_at(1)),
      last_flip_(-std::numeric_limits<double>::infinity()) {}

Synthesizer::Tone Synthesizer::tone_at(std::size_t index) const {
  const std::size_t i = std::min(index, course_.speeds.size() - 1);
  const double speed = course_.speeds[i], octaves = course_.leans[i] / (pi / 2);
  const double pitch = std::min(
      lowest_pitch * std::pow(1 + speed, pitch_exponent) * std::exp2(octaves), highest_pitch);
  // The power of the noise in the band is proportional to the pitch.
  const double uniform_power = 1.0 / 3;
  const double power = uniform_power * (pi / 4) * (pitch / quality) / (sample_rate / 2.0);
  const double amplitude = std::max(noise_amplitude(speed), room_amplitude);
  return {amplitude / std::sqrt(power), std::tan(pi * pitch / sample_rate)};
}

Synthesizer::Tone Synthesizer::next_tone() {
  const double place = static_cast<double>(next_) / sample_rate * course_.rate;
  while (place >= static_cast<double>(segment_ + 1)) {
    ++segment_;
    before_ = after_;
    after_ = tone_at(segment_ + 1);
  }
  const double share = place - static_cast<double>(segment_);
  return {std::lerp(before_.amplitude, after_.amplitude, share),
          std::lerp(before_.g, after_.g, share)};
}

double Synthesizer::next_accent() {
  const auto [a, b] = accent_recurrence;
  double value = a * accent_ - b * accent_before_;
  while (next_flip_ < course_.flips.size() &&
         course_.flips[next_flip_] * sample_rate <= static_cast<double>(next_)) {
    const double flip = course_.flips[next_flip_++];
    if (flip - last_flip_ < accent_spacing) continue;
    last_flip_ = flip;
    value += accent_amplitude * std::sin(2 * pi * accent_pitch / sample_rate);
  }
  // Processors are slow with numbers that are nearly zero.
  constexpr double inaudible = 1e-30;
  accent_before_ = accent_;
  accent_ = std::abs(value) < inaudible ? 0 : value;
  return accent_;
}

double Synthesizer::envelope() const {
  const double length = std::min(edge, course_.length / 4) * sample_rate;
  const double to_end = static_cast<double>(end_) - static_cast<double>(next_);
  return std::clamp(std::min(static_cast<double>(next_), to_end) / length, 0.0, 1.0);
}

void Synthesizer::synthesize(std::span<float> samples) {
  for (std::size_t i = 0; i + 1 < samples.size(); i += channels, ++next_) {
    const Tone tone = next_tone();
    const std::uint64_t noise = mixed(next_);
    // Half of the power is common to both sides, so that the sound is wide but has a centre.
    const double common = signed_unit(noise), side = signed_unit(noise >> 32U);
    constexpr double half = 1 / std::numbers::sqrt2;
    const BandFilter::Coefficients filter(tone.g);
    const double left = filters_[0].filter(half * (common + side), filter);
    const double right = filters_[1].filter(half * (common - side), filter);
    const double accent = next_accent(), faded = envelope();
    samples[i] = static_cast<float>(faded * (tone.amplitude * left + accent));
    samples[i + 1] = static_cast<float>(faded * (tone.amplitude * right + accent));
  }
}

}  // namespace twrench::sound
