// A run that waits after its first frame, so that a shell acts midway however busy the machine is.
#pragma once

#include <string>

namespace twrench {

/// Shell commands that start `render ARGUMENTS` in the background with its number in `$pid`, and
/// return when it has written f/frame_000000.png. The run then waits, because its standard output
/// is a full pipe, where it reports its progress.
inline std::string start_held(const std::string& arguments) {
  return "mkfifo hold; exec 9<>hold; rm hold; "
         "dd if=/dev/zero of=/dev/fd/9 oflag=nonblock bs=4096 2>/dev/null; "
         "env --default-signal=INT \"$TWRENCH\" render " +
         arguments +
         " --progress openjd >&9 9<&- & pid=$!; "
         "until [ -e f/frame_000000.png ]; do sleep 0.01; done; ";
}

/// Shell commands that let the run continue and wait for its end. The last status is the run's.
const std::string release_held = "exec 8</dev/fd/9 9<&-; cat <&8 >/dev/null & exec 8<&-; wait $pid";

}  // namespace twrench
