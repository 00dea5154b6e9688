#pragma once

#include <future>
#include <utility>
#include <variant>

#include "draw/soft_layer.h"
#include "picture/compose/layer.h"

namespace twrench::draw {

/// A layer of pixels or one without sharp detail.
using AnyLayer = std::variant<picture::Layer, SoftLayer>;

/// A layer that is still to be completed from pixels that were drawn: get() does that on the
/// calling thread. Where the pixels are in transfer from a graphics card (ReadMode::buffered), that
/// must be the thread that drew them.
using PendingLayer = std::future<AnyLayer>;

/// Returns the layer of either kind that `make` creates from the Image of `pixels.finish()`.
template <typename Pixels, typename Make>
PendingLayer made_of(Pixels pixels, Make make) {
  return std::async(std::launch::deferred,
                    [pixels = std::move(pixels), make = std::move(make)]() mutable -> AnyLayer {
                      return make(pixels.finish());
                    });
}

/// Returns the pixels unchanged as a layer at `x`, `y`.
template <typename Pixels>
PendingLayer made_of(Pixels pixels, int x, int y) {
  return made_of(std::move(pixels), [x, y](image::Image image) {
    return picture::Layer{std::move(image), x, y};
  });
}

/// Completes the layer on this thread.
inline void complete(PendingLayer& layer) {
  std::promise<AnyLayer> completed;
  completed.set_value(layer.get());
  layer = completed.get_future();
}

}  // namespace twrench::draw
