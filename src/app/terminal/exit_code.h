#pragma once

namespace twrench::app {

/// The exit codes of the process, which are part of the contract of the command line.
enum class ExitCode : int {
  done = 0,
  negative = 1,       ///< it ran, and the answer is no (compare: the images differ)
  usage = 2,          ///< a bad option or scene
  no_gl = 3,          ///< no usable OpenGL context
  encoder = 4,        ///< ffmpeg, or gnuplot for a figure, is missing, or it failed
  file = 5,           ///< a file could not be read or written
  internal = 70,      ///< a bug
  closed_pipe = 141,  ///< the reader of standard output has ended, as `head` does
  interrupted = 130,  ///< by SIGINT; all files written are complete
  terminated = 143,   ///< by SIGTERM; likewise
};

}  // namespace twrench::app
