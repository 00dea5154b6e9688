#pragma once

#include <optional>

#include "image/area.h"
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
  /// The smallest rectangle with all of those pixels; empty if there are none.
  Area area;
};

/// Returns the difference of two images; nothing if they differ in size or channels (`twrench
/// compare` then reports "different"). `threshold`, 0 to 255, is the one that `share` uses.
///
/// With `edges` above 0, a sample counts as equal if it lies between the least and the greatest
/// value of its channel within that many pixels, across and down, in the other image; otherwise its
/// difference is the distance from that range. An edge may therefore lie up to that many pixels
/// elsewhere, however it is antialiased. A detail in one image alone is still found, because each
/// image is compared with the other, and the larger difference counts.
std::optional<Difference> compare(const Image& a, const Image& b, int threshold, int edges = 0);
std::optional<Difference> compare(const DeepImage& a, const DeepImage& b, int threshold,
                                  int edges = 0);

/// Returns an RGB image of the differences of two images of the same size and channels: black where
/// they are equal, scaled so that the largest difference is white. A difference in alpha is gray.
Image difference_image(const Image& a, const Image& b, int edges = 0);
Image difference_image(const DeepImage& a, const DeepImage& b, int edges = 0);

/// The side of a window in pixels; smaller images have no structural similarity.
constexpr int similarity_window = 7;

/// Returns the mean structural similarity index (SSIM) of two images of the same size and number of
/// channels. It is at most 1, and 1 for equal images only. See Z. Wang, A. C. Bovik, H. R. Sheikh,
/// E. P. Simoncelli, "Image quality assessment: from error visibility to structural similarity",
/// IEEE Transactions on Image Processing 13 (2004), eq. 13. Windows are 7x7 samples of equal weight
/// within the image, covariances are sample covariances, K1 = 0.01 and K2 = 0.03, and the result is
/// the mean over the channels, as scikit-image's structural_similarity(a, b, channel_axis=-1)
/// returns it. Throws InvalidArgument if a side is shorter than a window.
double structural_similarity(const Image& a, const Image& b);
double structural_similarity(const DeepImage& a, const DeepImage& b);

}  // namespace twrench::image
