#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <optional>
#include <vector>

#include "app/progress.h"
#include "app/timing.h"
#include "image/image.h"
#include "movie/encoder.h"
#include "movie/frame_sequence.h"

namespace twrench {

/// Where the drawn frames go, and how.
struct Outputs {
  FrameSequence* sequence = nullptr;              ///< PNG files, or null
  VideoEncoder* encoder = nullptr;                ///< a video, or null
  int jobs = 1;                                   ///< threads that compress PNG files
  std::chrono::steady_clock::time_point start{};  ///< of the command, for the first frame's time
};

/// A frame's picture, and whether it is new: one that was kept from an earlier run has its file.
struct Picture {
  Image image;
  bool is_new = true;
  /// Where it is not the film's still background; nothing where that is not known.
  std::optional<std::vector<Area>> changed = std::nullopt;
};

/// How frames are drawn.
struct Drawing {
  /// Begins a frame, whose get() ends it.
  std::function<std::future<Picture>(const FrameRecord&)> begin;
  std::size_t ahead = 0;  ///< how many are begun before the one that is being ended
  /// Takes a picture when all stages are done with it, on the thread of the last; may be empty.
  std::function<void(Picture)> reuse = {};
};

/// Draws `frames` one after the other on this thread, while other threads compress and write those
/// before it and feed the encoder. Between the stages stand bounded queues, so that memory does not
/// depend on the film's length. Does not finish the outputs.
///
/// The first error of any stage ends the run after the frames that are on their way, and is thrown.
/// Throws FileError too where a thread cannot be started.
void run_pipeline(const std::vector<FrameRecord>& frames, const Drawing& drawing,
                  const Outputs& outputs, Progress& progress, StageTimes& times);

}  // namespace twrench
