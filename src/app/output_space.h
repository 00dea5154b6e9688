#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

#include "image/image.h"

namespace twrench {

/// What a run is to write.
struct PlannedOutput {
  std::optional<std::filesystem::path> frames_folder;
  std::optional<std::filesystem::path> film;
  std::size_t new_frames = 0;   ///< without a file yet
  std::size_t film_frames = 0;  ///< of the film
  double frame_pixels = 0;
};

/// Throws FileError where the disk has no room for it. First it is asked whether there is room for
/// frames that do not compress at all, and a film of two bits a pixel, which is mostly so. Only
/// else is a frame drawn: the estimate is then that all are a quarter larger as PNG, and the film a
/// tenth of them. (Measured of the default scene: no frame is a quarter larger than the mean, the
/// film a fiftieth.)
void require_space(const PlannedOutput& output, const std::function<Image()>& draw_one);

}  // namespace twrench
