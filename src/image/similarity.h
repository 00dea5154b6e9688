#pragma once

#include "image/image.h"

namespace twrench::image {

/// The smallest side of an image that has a structural similarity.
constexpr int similarity_window = 7;

/// Returns the mean structural similarity index (SSIM) of two images of one size and number of
/// channels, at most 1, which only equal images have: Z. Wang, A. C. Bovik, H. R. Sheikh, E. P.
/// Simoncelli, "Image quality assessment: from error visibility to structural similarity", IEEE
/// Transactions on Image Processing 13 (2004), eq. 13, over windows of 7x7 samples of equal weight
/// that lie within the image, with sample covariances, K1 = 0.01 and K2 = 0.03; the mean over the
/// channels. It is what scikit-image's structural_similarity(a, b, channel_axis=-1) returns.
/// Throws InvalidArgument when a side is shorter than a window.
double structural_similarity(const Image& a, const Image& b);
double structural_similarity(const DeepImage& a, const DeepImage& b);

}  // namespace twrench::image
