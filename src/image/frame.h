#pragma once

#include <vector>

#include "image/area.h"
#include "image/image.h"

namespace twrench::image {

/// A frame of a video, from the renderer to the outputs and back.
struct Frame {
  /// RGBA if the scene is transparent, otherwise RGB.
  Image image;
  /// The damaged areas: where it differs from the static background. They may overlap.
  std::vector<Area> damage;
  /// Whether this run drew it; a frame kept from an earlier run already has its file.
  bool is_new = true;
};

}  // namespace twrench::image
