#pragma once

#include <future>
#include <utility>

#include "render/layer.h"

namespace twrench {

/// A layer whose pixels may still be on their way: then it is deferred, and get() waits for them
/// and does what is left to do, on the thread that calls it: the one that drew. Else it is ready.
using PendingLayer = std::future<Layer>;

/// One that is ready.
inline PendingLayer ready(Layer layer) {
  std::promise<Layer> promise;
  promise.set_value(std::move(layer));
  return promise.get_future();
}

/// The layer that `make` makes of an Image: of what take() gives, when `pixels` are there.
template <typename Pixels, typename Make>
PendingLayer made_of(Pixels pixels, Make make) {
  if (pixels.is_there()) return ready(make(pixels.take()));
  return std::async(std::launch::deferred,
                    [pixels = std::move(pixels), make = std::move(make)]() mutable {
                      return make(pixels.take());
                    });
}

/// The pixels as they are, from `x`, `y` on.
template <typename Pixels>
PendingLayer made_of(Pixels pixels, int x, int y) {
  return made_of(std::move(pixels), [x, y](Image image) { return Layer{std::move(image), x, y}; });
}

}  // namespace twrench
