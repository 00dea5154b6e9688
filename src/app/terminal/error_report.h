#pragma once

#include <twrench/base/error.h>

#include "film/page_pictures.h"
#include "scene/scene.h"
#include "system/termination.h"

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

/// Returns the remedy on the command line: the error's own or, if an option helps, one that names
/// the option; may be empty.
std::string remedy_for(const Error& error);

/// Prints the exception being handled on standard error, as "twrench: error: WHAT: WHY" with the
/// remedy on a second line, and returns its exit code. Call it in a catch clause. `draws` is
/// whether the failed command draws frames, and so could use less memory.
ExitCode report_current_exception(bool draws);

/// Prints, in the same way, that a signal ends the program, and returns its exit code.
ExitCode report_termination(const system::TerminationMessage& message);

/// Returns the pictures of a page. If nothing can be drawn, warns and returns none, because a page
/// works without pictures.
film::PagePictures pictures_or_nothing(const scene::Scene& scene, bool has_article);

}  // namespace twrench::app
