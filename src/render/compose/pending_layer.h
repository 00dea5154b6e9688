#pragma once

#include <future>
#include <utility>
#include <variant>

#include "render/compose/layer.h"
#include "render/compose/soft_layer.h"

namespace twrench::render {

/// A layer of pixels or one without sharp detail.
using AnyLayer = std::variant<Layer, SoftLayer>;

/// A layer whose pixels may still be in transfer. If so it is deferred: get() waits for them and
/// completes the layer on the calling thread, which must be the one that drew it. Otherwise it is
/// ready.
using PendingLayer = std::future<AnyLayer>;

/// Returns a layer that is ready.
inline PendingLayer ready(AnyLayer layer) {
  std::promise<AnyLayer> promise;
  promise.set_value(std::move(layer));
  return promise.get_future();
}

/// Returns the layer of either kind that `make` creates from the Image of take(), once `pixels`
/// have arrived.
template <typename Pixels, typename Make>
PendingLayer made_of(Pixels pixels, Make make) {
  if (pixels.is_ready()) return ready(make(pixels.finish()));
  return std::async(std::launch::deferred,
                    [pixels = std::move(pixels), make = std::move(make)]() mutable -> AnyLayer {
                      return make(pixels.finish());
                    });
}

/// Returns the pixels unchanged as a layer at `x`, `y`.
template <typename Pixels>
PendingLayer made_of(Pixels pixels, int x, int y) {
  return made_of(std::move(pixels), [x, y](image::Image image) {
    return Layer{std::move(image), x, y};
  });
}

}  // namespace twrench::render
