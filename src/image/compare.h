#pragma once

#include <optional>

#include "image/image.h"

namespace twrench::image {

/// The difference between two images in units of 1/255 of a channel, with fractions for images of
/// 16 bits per channel.
struct Difference {
  /// The largest over all pixels and channels.
  double max = 0.0;
  /// The mean over all pixels and channels.
  double mean = 0.0;
  /// Fraction of pixels, 0 to 1, with a channel that differs by more than the threshold.
  double share = 0.0;
};

/// Returns the difference of two images; nothing if they differ in size or channels (`twrench
/// compare` then reports "different"). `threshold`, 0 to 255, is the one that `share` uses.
std::optional<Difference> compare(const Image& a, const Image& b, int threshold);
std::optional<Difference> compare(const DeepImage& a, const DeepImage& b, int threshold);

/// Returns an RGB image of the differences of two images of the same size and channels: black where
/// they are equal, scaled so that the largest difference is white. A difference in alpha is gray.
Image difference_image(const Image& a, const Image& b);
Image difference_image(const DeepImage& a, const DeepImage& b);

}  // namespace twrench::image
