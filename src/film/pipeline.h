#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "image/frame.h"
#include "system/error.h"
#include "video/encoder.h"
#include "video/frame_sequence.h"

namespace twrench::film {

/// Busy time of each stage of a render in nanoseconds, summed over all its threads.
struct StageTimes {
  using Counter = std::atomic<std::int64_t>;

  Counter pose{0};       ///< Integrating the motion.
  Counter draw{0};       ///< Drawing and reading back; a software rasteriser draws during reading.
  Counter composite{0};  ///< Drawing the parts that need no OpenGL, and compositing.
  Counter convert{0};    ///< Converting to the encoder's colours.
  Counter compress{0};   ///< Compressing PNG.
  Counter write{0};      ///< Writing PNG files and computing their digests.
  Counter encode{0};     ///< Feeding the encoder, including waiting for it.
  Counter first{0};      ///< Not a stage: the time from the start to the first frame written.
};

/// Adds its lifetime to a stage.
class Timed {
 public:
  explicit Timed(StageTimes::Counter& total) : total_(total) {}
  ~Timed() {
    total_ += std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start_).count();
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  StageTimes::Counter& total_;
  Clock::time_point start_ = Clock::now();
};

/// The outputs of drawn frames.
struct Outputs {
  /// PNG files, or null.
  video::FrameSequence* sequence = nullptr;
  /// The video, or null.
  video::VideoEncoder* encoder = nullptr;
  /// Number of threads that compress PNG files.
  int jobs = 1;
  /// Start of the run, for measuring the time to the first frame.
  std::chrono::steady_clock::time_point start{};
};

/// Receives the number of frames drawn and the number of all frames.
using ProgressCallback = std::function<void(int done, int total)>;

/// How frames are drawn.
struct Drawing {
  /// Begins the frame with that index.
  std::function<image::PendingFrame(std::size_t index)> begin;
  /// Number of frames that are begun before the oldest is fetched.
  std::size_t ahead = 0;
};

/// Draws `frames` in sequence on this thread while other threads composite earlier frames, compress
/// and write them, and feed the encoder. Bounded queues connect the stages, so that memory use does
/// not depend on the length of the video. Does not finish the outputs. Calls `progress`, which may
/// be empty, on this thread after each frame.
///
/// The first error of any stage, or of `progress`, ends the run after the frames in flight, and is
/// thrown. Throws ThreadError if a thread cannot be started.
void run_pipeline(const std::vector<video::FrameRecord>& frames, const Drawing& drawing,
                  const Outputs& outputs, const ProgressCallback& progress, StageTimes& times);

}  // namespace twrench::film
