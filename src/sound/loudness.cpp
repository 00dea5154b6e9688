#include "sound/loudness.h"

#include <ebur128.h>

#include <cstddef>
#include <memory>
#include <new>

#include "sound/sample_rate.h"

namespace twrench::sound {
namespace {

struct Destroy {
  void operator()(ebur128_state* state) const { ebur128_destroy(&state); }
};

/// The library fails only if memory is exhausted.
void require_success(int error) {
  if (error != EBUR128_SUCCESS) throw std::bad_alloc();
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

}  // namespace twrench::sound
