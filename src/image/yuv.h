#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/area.h"
#include "image/image.h"
#include "image/yuv_rows.h"

namespace twrench {

/// A picture as encoders take it: planar Y'CbCr 4:2:0, 8 bits, BT.709, limited range (Y' 16 to 235,
/// Cb and Cr 16 to 240). Chroma is sited as H.264 and MPEG-2 have it unless told otherwise: across,
/// on every second column, down, between two rows.
class Yuv420 {
 public:
  /// Of an image that is yet to be given: the whole of it is to be updated before bytes() are used.
  Yuv420(int width, int height);

  /// Converts those pixels of `area`, which lies inside, and the chroma that they bear on. `image`
  /// is RGB of this size. What is not in an area stays: parts that do not move are converted once.
  /// A conversion depends on the image alone, not on how it was cut into areas.
  void update(const Image& image, const Area& area);

  /// The planes Y', Cb, Cr, one after the other: rows from the top, no padding. Those of chroma
  /// have half the width and height, rounded up.
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  void update_luma(const Image& image, const Area& area);
  void update_chroma(const Image& image, const Area& area);

  int width_;
  int height_;
  YuvRows rows_;
  std::vector<std::uint8_t> bytes_;
  std::vector<int> blue_columns_;  ///< scratch: of two rows, from the one before the first column
  std::vector<int> red_columns_;
};

}  // namespace twrench
