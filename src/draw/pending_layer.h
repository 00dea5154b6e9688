#pragma once

#include <functional>
#include <utility>
#include <variant>

#include "draw/exposure.h"
#include "draw/soft_layer.h"
#include "gl/readback.h"
#include "picture/compose/layer.h"

namespace twrench::draw {

/// A layer of pixels or one without sharp detail.
using AnyLayer = std::variant<picture::Layer, SoftLayer>;

/// A layer that was drawn, but whose pixels may still be in transfer from a graphics card.
struct PendingLayer {
  std::variant<gl::Readback, PendingExposure> pixels;
  /// Makes the layer from the pixels, on any thread.
  std::function<AnyLayer(image::Image)> make;

  /// Waits for the pixels, on the thread that drew them.
  void fetch() {
    std::visit([](auto& any) { any.fetch(); }, pixels);
  }

  /// Returns the layer, on any thread after fetch(). Call it once.
  AnyLayer finish() {
    return make(std::visit([](auto& any) { return any.finish(); }, pixels));
  }
};

/// Returns the pixels unchanged as a layer with its top left corner in that of `area`.
inline PendingLayer layer_at(const image::Area& area,
                             std::variant<gl::Readback, PendingExposure> pixels) {
  return {std::move(pixels), [x = area.x, y = area.y](image::Image image) {
            return picture::Layer{std::move(image), x, y};
          }};
}

}  // namespace twrench::draw
