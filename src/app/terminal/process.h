#pragma once

namespace twrench::app {

/// Prepares the process so that all failures can be reported: opens missing standard streams,
/// handles termination signals, and makes failed writes return errors instead of raising signals.
/// Call it first.
void prepare_process();

/// Reports that memory ran out, or else that there is a bug, and ends the process with exit code 70
/// after removing its temporary files. For situations in which nothing can be thrown to main();
/// allocates no memory.
[[noreturn]] void end_at_once() noexcept;

}  // namespace twrench::app
