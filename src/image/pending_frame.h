#pragma once

#include <functional>

#include "image/frame.h"

namespace twrench::image {

/// A frame in progress: it is drawn, but its pixels may still be in transfer, and it is not yet
/// composited. Two functions complete it; each is called once, in this order. Copies share the
/// frame.
struct PendingFrame {
  /// Waits for the pixels. Call it on the thread that draws.
  std::function<void()> fetch;
  /// Completes the frame, on any thread. Throws as the functions that draw its parts do.
  std::function<Frame()> composite;

  /// Does both on the thread that draws.
  Frame get() const {
    fetch();
    return composite();
  }
};

}  // namespace twrench::image
