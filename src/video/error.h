#pragma once

#include <vector>

#include "system/error.h"

namespace twrench::video {

/// ffmpeg is missing, lacks the encoder, or failed.
struct EncoderError : Error {
  using Error::Error;
};

/// A film of a size that its format cannot have.
class FilmSizeError : public InvalidArgument {
 public:
  /// `width` and `height`, pixels, are the nearest that it can have, and no smaller.
  FilmSizeError(const std::string& quantity, const std::string& why, int width, int height)
      : InvalidArgument(quantity, why), width_(width), height_(height) {}

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }

 private:
  int width_, height_;
};

/// A folder's frames are not those that its manifests tell of.
class FramesError : public system::FileError {
 public:
  enum class Reason {
    no_manifest,    ///< of that folder
    contradictory,  ///< manifests tell of different films
    missing,        ///< frames that were asked for are not there
    altered,        ///< a frame is not the file that was drawn
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
