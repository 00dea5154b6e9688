#pragma once

#include <vector>

#include "system/error.h"

namespace twrench::video {

/// ffmpeg is missing, lacks the encoder, or failed.
struct EncoderError : Error {
  using Error::Error;
};

/// The remedy if ffmpeg is missing.
inline constexpr const char* ffmpeg_remedy =
    "install it: apt-get install ffmpeg; without root, put an ffmpeg and its ffprobe into a folder "
    "of PATH";

/// The format of a film does not support its size.
class FilmSizeError : public InvalidArgument {
 public:
  /// `width` and `height` are the nearest supported size in pixels that is not smaller.
  FilmSizeError(const std::string& quantity, const std::string& why, int width, int height)
      : InvalidArgument(quantity, why), width_(width), height_(height) {}

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }

 private:
  int width_, height_;
};

/// The frames in a folder do not match its manifests.
class FramesError : public system::FileError {
 public:
  enum class Reason {
    no_manifest,    ///< the folder has none
    contradictory,  ///< manifests describe different films
    missing,        ///< requested frames do not exist
    altered,        ///< a file differs from the frame that was drawn
  };

  FramesError(const std::string& what, const std::string& why, Reason reason,
              std::vector<int> frames = {})
      : system::FileError(what, why), reason_(reason), frames_(std::move(frames)) {}

  Reason reason() const noexcept { return reason_; }
  /// The frames that are missing or altered, ascending.
  const std::vector<int>& frames() const noexcept { return frames_; }

 private:
  Reason reason_;
  std::vector<int> frames_;
};

}  // namespace twrench::video
