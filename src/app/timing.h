#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace twrench {

/// User and system time in milliseconds. Of a process, and so with that of the shell that became
/// this program, and of the shell's children before: only differences tell of this program.
struct ProcessorTime {
  double own, children;  ///< of the children, those that have ended
};

ProcessorTime processor_time();

/// Busy time of each stage of a film in nanoseconds, over all its threads.
struct StageTimes {
  using Counter = std::atomic<std::int64_t>;

  Counter pose{0};      ///< the motion, integrated
  Counter draw{0};      ///< drawing and reading back: a software rasteriser draws when it is read
  Counter convert{0};   ///< to the encoder's colours
  Counter compress{0};  ///< PNG
  Counter write{0};     ///< PNG files with their digests
  Counter encode{0};    ///< feeding the encoder, which is to wait for it
  Counter first{0};     ///< not a stage: from the start to the first frame that was written

  ProcessorTime before = processor_time();  ///< what is not this film's
};

/// Adds the time of its own life to a stage.
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

/// What a film took, for people: one line, or with `json` for programs: one JSON object on a line.
/// `seconds` is the wall time of all of it. Processor time is what the system counts until now.
std::string timing_report(const StageTimes& times, double seconds, std::size_t frames, bool json);

}  // namespace twrench
