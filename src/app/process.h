#pragma once

namespace twrench {

/// Makes the process one whose faults can be told: standard streams that are open, signals that end
/// it in order, writes that fail with an error and not with a signal. To be called first.
void prepare_process();

/// Says that memory ran out, or else that there is a bug, and ends the process with exit code 70,
/// its temporary files removed. For where nothing can be thrown to main(); takes no memory.
[[noreturn]] void end_at_once() noexcept;

}  // namespace twrench
