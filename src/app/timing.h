#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace twrench::app {

/// User and system time in milliseconds. It is that of the process, including the shell that became
/// this program, and the shell's earlier children; only differences are meaningful.
struct ProcessorTime {
  double own, children;  ///< `children` counts those that have ended.
};

ProcessorTime processor_time();

/// Busy time of each stage of a render in nanoseconds, summed over all its threads.
struct StageTimes {
  using Counter = std::atomic<std::int64_t>;

  Counter pose{0};      ///< Integrating the motion.
  Counter draw{0};      ///< Drawing and reading back; a software rasteriser draws when it is read.
  Counter convert{0};   ///< Converting to the encoder's colours.
  Counter compress{0};  ///< Compressing PNG.
  Counter write{0};     ///< Writing PNG files and computing their digests.
  Counter encode{0};    ///< Feeding the encoder, including waiting for it.
  Counter first{0};     ///< Not a stage: the time from the start to the first frame written.

  ProcessorTime before = processor_time();  ///< CPU time before the render.
};

/// Adds its own lifetime to a stage.
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

/// Returns the timing of a render as one line for users, or with `json` as a JSON object on one
/// line. `seconds` is the total wall time. CPU time is that counted by the system so far.
std::string timing_report(const StageTimes& times, double seconds, std::size_t frames, bool json);

}  // namespace twrench::app
