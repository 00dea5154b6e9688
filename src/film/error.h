#pragma once

#include "system/error.h"

namespace twrench::film {

/// The folder has frames that may belong to another video.
class ForeignFramesError : public system::OverwriteError {
 public:
  /// `sharded`: whether the run draws one of several shards into the folder; `unrecorded`: whether
  /// no manifest describes the frames, as in a folder of golden images.
  ForeignFramesError(const std::string& what, const std::string& why, bool sharded, bool unrecorded)
      : system::OverwriteError(what, why), sharded_(sharded), unrecorded_(unrecorded) {}

  bool sharded() const noexcept { return sharded_; }
  bool unrecorded() const noexcept { return unrecorded_; }

 private:
  bool sharded_, unrecorded_;
};

/// The disk has too little space for the frames and the video.
struct SpaceError : system::FileError {
  using FileError::FileError;
};

/// The system refuses to start the threads that compress frames.
struct ThreadError : system::FileError {
  using FileError::FileError;
};

}  // namespace twrench::film
