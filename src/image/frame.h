#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "image/area.h"
#include "image/image.h"

namespace twrench::image {

/// A frame of a video, from the renderer to the outputs and back.
struct Frame {
  /// RGBA if the scene is transparent, otherwise RGB.
  Image image;
  /// The damaged areas: where it differs from the static background. They may overlap.
  std::vector<Area> damage;
  /// Whether this run drew it; a frame kept from an earlier run already has its file.
  bool is_new = true;
  /// The static background, the same object in all frames that have it; null if there is none.
  std::shared_ptr<const Image> background = nullptr;
};

/// A result in progress: it is drawn, but its pixels may still be in transfer, and it is not yet
/// complete. Two functions complete it; each is called once, in this order. Copies share the
/// result.
template <typename Result>
struct Pending {
  /// Waits for the pixels. Call it on the thread that draws.
  std::function<void()> fetch;
  /// Completes the result, on any thread. Throws as the functions that draw its parts do.
  std::function<Result()> finish;

  /// Does both on the thread that draws.
  Result get() const {
    fetch();
    return finish();
  }
};

using PendingFrame = Pending<Frame>;

}  // namespace twrench::image
