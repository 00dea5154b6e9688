#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

#include "image/image.h"

namespace twrench::film {

/// The planned output of a run.
struct PlannedOutput {
  /// Folder of the frames; nothing if none are written.
  std::optional<std::filesystem::path> frames_folder;
  /// File of the video; nothing if none is written.
  std::optional<std::filesystem::path> film;
  /// Number of frames without a file yet.
  std::size_t new_frames = 0;
  /// Number of frames of the video.
  std::size_t film_frames = 0;
  /// Number of pixels of a frame.
  double frame_pixels = 0;
};

/// Throws SpaceError if the disk has too little space. First it checks for space for uncompressed
/// frames and a video of two bits per pixel, which there usually is. Only if there is not, it draws
/// a frame and estimates that every PNG is a quarter larger, and the video a tenth of the PNGs.
/// (Measured with the default scene: no frame is a quarter larger than the mean, and the video is a
/// fiftieth.)
void require_space(const PlannedOutput& output, const std::function<image::Image()>& draw_one);

}  // namespace twrench::film
