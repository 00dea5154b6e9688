#pragma once

#include <deque>
#include <vector>

#include "gl/framebuffer.h"
#include "image/image.h"

namespace twrench::draw {

/// Averages images in linear light, as an open shutter does.
class Exposure {
 public:
  /// `width` and `height` are those of the images.
  Exposure(int width, int height);

  /// Adds an image, which is premultiplied RGBA.
  void add(const image::Image& image);

  /// Returns the mean of the images added, at least one, as premultiplied RGBA.
  image::Image mean() const;

 private:
  int width_, height_;
  int count_ = 0;
  /// Sums of each pixel's linear red, green and blue, each times alpha, and of alpha.
  std::vector<float> sums_;
};

/// An exposure whose pictures may still be in transfer from a graphics card.
class PendingExposure {
 public:
  /// `width` and `height` are those of the pictures.
  PendingExposure(int width, int height) : exposure_(width, height) {}
  PendingExposure(PendingExposure&&) = default;  // otherwise a vector would copy it

  /// Adds a picture. If many are in transfer, it waits for the first.
  void add(gl::Readback picture);

  /// Waits for all pictures.
  void fetch();

  /// Returns the mean of all, on any thread after fetch().
  image::Image finish() const { return exposure_.mean(); }

 private:
  void add_first();

  Exposure exposure_;
  std::deque<gl::Readback> in_transfer_;
};

/// Returns the mean, in linear light, of two pictures of the same size: `share` of the second and
/// the rest of the first. Both are RGB, or RGBA with unpremultiplied alpha.
image::Image cross_fade(const image::Image& from, const image::Image& to, double share);

}  // namespace twrench::draw
