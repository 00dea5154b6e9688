#pragma once

#include "image/image.h"

namespace twrench::image {

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
