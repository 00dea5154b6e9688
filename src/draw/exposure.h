#pragma once

#include <vector>

#include "image/image.h"

namespace twrench::draw {

/// Averages images in linear light, as an open shutter does.
class Exposure {
 public:
  /// For images of that size.
  Exposure(int width, int height);

  /// Adds an image: RGBA, premultiplied.
  void add(const image::Image& image);

  /// Returns the mean of the images added, at least one, as premultiplied RGBA.
  image::Image mean() const;

 private:
  int width_, height_;
  int count_ = 0;
  /// Sums of each pixel's linear red, green and blue, each times alpha, and of alpha.
  std::vector<float> sums_;
};

}  // namespace twrench::draw
