#pragma once

#include <cstddef>
#include <string>

#include "film/stage_times.h"

namespace twrench::app {

/// User and system time in milliseconds. It is that of the process, including the shell that became
/// this program, and the shell's earlier children; only differences are meaningful.
struct ProcessorTime {
  double own, children;  ///< `children` counts those that have ended.
};

ProcessorTime processor_time();

/// Returns the timing of a render as one line for users, or with `json` as a JSON object on one
/// line. `seconds` is the total wall time; CPU time is that counted by the system since `before`.
std::string timing_report(const film::StageTimes& times, const ProcessorTime& before,
                          double seconds, std::size_t frames, bool json);

}  // namespace twrench::app
