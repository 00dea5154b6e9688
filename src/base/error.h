#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace twrench {

/// What the process reports to its caller; the contract of the command line.
enum class ExitCode : int {
  done = 0,
  answer_is_no = 1,   ///< it ran, and the answer is no (compare: the images differ)
  usage = 2,          ///< a bad option or scene
  no_gl = 3,          ///< no usable OpenGL context
  encoder = 4,        ///< ffmpeg, or gnuplot for a figure, is missing, or it failed
  file = 5,           ///< a file could not be read or written
  internal = 70,      ///< a bug
  interrupted = 130,  ///< by SIGINT; what was written is whole
  terminated = 143,   ///< by SIGTERM; likewise
};

/// A failure that a user can act on: WHAT failed, WHY, and where there is one the remedy.
/// Caught once, in the application, which prints "twrench: error: WHAT: WHY" and the remedy below.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& what, const std::string& why, std::string remedy = {})
      : std::runtime_error(what + ": " + why), code_(code), remedy_(std::move(remedy)) {}

  ExitCode code() const noexcept { return code_; }
  const std::string& remedy() const noexcept { return remedy_; }

 private:
  ExitCode code_;
  std::string remedy_;
};

/// A bad option or scene (exit code 2).
struct UsageError : Error {
  UsageError(const std::string& what, const std::string& why, std::string remedy = {})
      : Error(ExitCode::usage, what, why, std::move(remedy)) {}
};

/// No usable OpenGL context, or the context cannot do what was asked (exit code 3).
struct GlError : Error {
  GlError(const std::string& what, const std::string& why, std::string remedy = {})
      : Error(ExitCode::no_gl, what, why, std::move(remedy)) {}
};

/// ffmpeg is missing, lacks the encoder, or failed (exit code 4).
struct EncoderError : Error {
  EncoderError(const std::string& what, const std::string& why, std::string remedy = {})
      : Error(ExitCode::encoder, what, why, std::move(remedy)) {}
};

/// gnuplot is missing, lacks the format, or failed (exit code 4).
struct FigureError : Error {
  FigureError(const std::string& what, const std::string& why, std::string remedy = {})
      : Error(ExitCode::encoder, what, why, std::move(remedy)) {}
};

/// A file could not be read or written (exit code 5).
struct FileError : Error {
  FileError(const std::string& what, const std::string& why, std::string remedy = {})
      : Error(ExitCode::file, what, why, std::move(remedy)) {}
};

}  // namespace twrench
