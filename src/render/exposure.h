#pragma once

#include <vector>

#include "image/image.h"

namespace twrench {

/// The mean of pictures, in linear light, as a shutter that is open for a while takes it.
class Exposure {
 public:
  /// Of pictures of that size.
  Exposure(int width, int height);

  /// Adds a picture: RGBA, premultiplied.
  void add(const Image& image);

  /// The mean of those added, at least one, as RGBA, premultiplied.
  Image mean() const;

 private:
  int width_, height_;
  int count_ = 0;
  std::vector<float> sums_;  ///< of a pixel's linear red, green, blue, each times alpha, and alpha
};

}  // namespace twrench
