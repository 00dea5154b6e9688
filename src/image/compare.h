#pragma once

#include <optional>

#include "image/image.h"

namespace twrench {

/// How far two images are apart, in steps of 1/255 of a channel; of images with 16 bits a channel
/// also in parts of such a step.
struct Difference {
  double max = 0.0;   ///< the largest, over all pixels and channels
  double mean = 0.0;  ///< over all pixels and channels
  double share =
      0.0;  ///< of the pixels, 0 to 1: those of which a channel differs by more than asked
};

/// The difference of two images; nothing when they differ in size or channels, where there is none
/// (`twrench compare` then answers "different"). `threshold`, 0 to 255, is what `share` counts
/// from.
std::optional<Difference> compare(const Image& a, const Image& b, int threshold);
std::optional<Difference> compare(const DeepImage& a, const DeepImage& b, int threshold);

/// Where two images of the same size and channels differ: RGB, black where they are equal, the
/// largest difference made white so that the smallest shows. A difference of alpha is gray.
Image difference_image(const Image& a, const Image& b);
Image difference_image(const DeepImage& a, const DeepImage& b);

}  // namespace twrench
