#pragma once

#include <future>
#include <utility>

#include "image/frame.h"

namespace twrench::image {

/// A frame in progress: drawn, but its pixels may still be in transfer, and it is not composited.
class PendingFrame {
 public:
  /// Both are deferred, and called once, in this order: `transfer` on the thread that draws, then
  /// `composition` on any thread.
  PendingFrame(std::future<void> transfer, std::future<Frame> composition)
      : transfer_(std::move(transfer)), composition_(std::move(composition)) {}

  /// Waits for the pixels. Call it on the thread that draws.
  void fetch() { transfer_.get(); }

  /// Completes the frame after fetch(), on any thread, but not on two at once. Throws as what it is
  /// made of does.
  Frame composite() { return composition_.get(); }

  /// Does both on the thread that draws.
  Frame get() {
    fetch();
    return composite();
  }

 private:
  std::future<void> transfer_;
  std::future<Frame> composition_;
};

}  // namespace twrench::image
