#include "draw/blank_frames.h"

#include <algorithm>

namespace twrench::draw {
namespace {

/// Copies the background to the image within `area`.
void restore(image::Image& image, const image::Image& background, const image::Area& area) {
  const auto channels = static_cast<std::size_t>(background.channels);
  for (int row = area.y; row < area.y + area.height; ++row) {
    const auto first =
        static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * background.row_bytes() +
                                    static_cast<std::size_t>(area.x) * channels);
    std::copy_n(background.pixels.begin() + first, static_cast<std::size_t>(area.width) * channels,
                image.pixels.begin() + first);
  }
}

}  // namespace

BlankFrames::BlankFrames(image::Image background) : background_(std::move(background)) {
  used_.reserve(most);
}

image::Frame BlankFrames::acquire() {
  image::Frame frame;
  {
    const std::lock_guard lock(mutex_);
    if (used_.empty()) return {background_, {}, true, bands_};
    frame = std::move(used_.back());
    used_.pop_back();
  }
  for (const image::Area& area : frame.damage) restore(frame.image, background_, area);
  frame.damage.clear();
  return frame;
}

void BlankFrames::give_back(image::Frame frame) noexcept {
  // A frame's alpha is unpremultiplied; the static background's is premultiplied.
  if (background_.channels == 4) return;
  const std::lock_guard lock(mutex_);
  if (used_.size() < most) used_.push_back(std::move(frame));
}

}  // namespace twrench::draw
