#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "image/frame.h"

namespace twrench::draw {

/// A pool of frames to draw into, made from drawn frames that are no longer needed.
class BlankFrames {
 public:
  /// `background` is the static background, premultiplied if it is RGBA.
  explicit BlankFrames(image::Image background);

  const image::Image& static_background() const { return background_; }

  /// Returns the compressed static background, which all frames share.
  const std::shared_ptr<image::StaticBands>& bands() const { return bands_; }

  /// Returns a frame that shows the static background.
  image::Frame acquire();

  /// Takes a frame back: only its damaged areas need to be restored then. Thread-safe.
  void give_back(image::Frame frame) noexcept;

 private:
  static constexpr std::size_t most = 16;  // as many as are in progress at once

  image::Image background_;
  const std::shared_ptr<image::StaticBands> bands_ = std::make_shared<image::StaticBands>();
  std::mutex mutex_;
  std::vector<image::Frame> used_;
};

}  // namespace twrench::draw
