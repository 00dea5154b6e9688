#pragma once

#include <concepts>
#include <future>
#include <utility>

#include "gl/readback.h"
#include "render/layer.h"

namespace twrench {

/// A layer whose pixels may still be on their way. get() waits for them and does what is left to
/// do, on the thread that calls it: the one that drew.
using PendingLayer = std::future<Layer>;

/// A layer that `make` makes, when it is asked for.
template <std::invocable Make>
PendingLayer pending(Make make) {
  return std::async(std::launch::deferred, std::move(make));
}

/// One that is there.
inline PendingLayer pending(Layer layer) {
  return pending([layer = std::move(layer)]() mutable { return std::move(layer); });
}

/// Pixels just as they are read, from `x`, `y` on.
inline PendingLayer pending(gl::Readback pixels, int x, int y) {
  return pending([pixels = std::move(pixels), x, y]() mutable {
    return Layer{pixels.take(), x, y};
  });
}

}  // namespace twrench
