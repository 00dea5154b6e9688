#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

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

}  // namespace twrench::film
