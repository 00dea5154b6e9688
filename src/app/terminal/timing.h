#pragma once

#include <cstddef>
#include <string>

#include "film/stage_times.h"

namespace twrench::app {

/// User and system time in milliseconds. A shell may have become this program by exec, and then its
/// time and that of its children are included, so only differences are meaningful.
struct ProcessorTime {
  double own, children;  ///< `children` counts those that have ended.
};

ProcessorTime processor_time();

/// Returns the timing of a render as one line for users, or with `json` as a JSON object on one
/// line. `seconds` is the total wall time; CPU time is that counted by the system since `before`.
std::string timing_report(const film::StageTimes& times, const ProcessorTime& before,
                          double seconds, std::size_t frames, bool json);

}  // namespace twrench::app
