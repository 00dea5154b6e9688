#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/area.h"
#include "image/image.h"

namespace twrench::image {

/// The arithmetic of Yuv420 by rows. Output ranges must not overlap other ranges.
struct YuvRows {
  /// Converts `count` pixels to Y'.
  void (*luma)(const std::uint8_t* rgb, std::uint8_t* out, int count);

  /// Computes the weights of `count` columns of two rows in Cb and Cr, as sums that are not yet
  /// rounded.
  void (*columns)(const std::uint8_t* upper, const std::uint8_t* lower, int* blue, int* red,
                  int count);

  /// Computes Cb or Cr: sample i from columns 2i to 2i + 2, with double weight on the middle one.
  void (*chroma)(const int* columns, std::uint8_t* out, int count);
};

/// Returns the implementation for all processors.
YuvRows common_yuv_rows();

/// Returns the implementation with the widest instructions of this processor; its results are the
/// same.
YuvRows fastest_yuv_rows();

/// An image as video encoders take it: planar Y'CbCr 4:2:0, 8 bits, BT.709, limited range (Y' 16 to
/// 235, Cb and Cr 16 to 240). The chroma location is left, the default of H.264 and MPEG-2:
/// horizontally on every second column, vertically between two rows.
class Yuv420 {
 public:
  /// Reserves the planes. update() must cover the whole image before bytes() is used.
  Yuv420(int width, int height);

  /// Converts the pixels of `area`, which must lie inside, and the chroma that depends on them.
  /// `image` is RGB of this size. The rest keeps its values, so that static parts are converted
  /// once. The result depends only on the image, not on how it was divided into areas.
  void update(const Image& image, const Area& area);

  /// Returns the planes Y', Cb and Cr in this order: rows from the top, no padding. The chroma
  /// planes have half the width and height, rounded up.
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  void update_luma(const Image& image, const Area& area);
  void update_chroma(const Image& image, const Area& area);

  int width_;
  int height_;
  YuvRows rows_;
  std::vector<std::uint8_t> bytes_;
  std::vector<int> blue_columns_;  ///< Scratch for two rows, from the column before the first.
  std::vector<int> red_columns_;
};

}  // namespace twrench::image
