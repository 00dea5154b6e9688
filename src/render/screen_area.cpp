#include "render/screen_area.h"

#include <algorithm>
#include <cmath>

namespace twrench {

void ScreenArea::add(const Eigen::Vector4f& clip, float margin) {
  if (clip.w() <= 0) {
    all_ = true;
    return;
  }
  const Eigen::Array2f size(static_cast<float>(pane_.width), static_cast<float>(pane_.height));
  const Eigen::Array2f place(clip.x() / clip.w(), -clip.y() / clip.w());
  const Eigen::Array2f pixel = (0.5F + 0.5F * place) * size;
  low_ = low_.min(pixel - margin);
  high_ = high_.max(pixel + margin);
}

Area ScreenArea::area() const {
  if (all_) return pane_;
  // Compared as floats first: a point just before the eye's plane lies farther off than an int
  // goes.
  const auto first = [](float low, int size) {
    return static_cast<int>(std::floor(std::clamp(low - 1, 0.0F, static_cast<float>(size - 1))));
  };
  const auto end = [](float high, int size) {
    return static_cast<int>(std::ceil(std::clamp(high + 1, 1.0F, static_cast<float>(size))));
  };
  const int x = first(low_.x(), pane_.width);
  const int y = first(low_.y(), pane_.height);
  return {pane_.x + x, pane_.y + y, std::max(1, end(high_.x(), pane_.width) - x),
          std::max(1, end(high_.y(), pane_.height) - y)};
}

}  // namespace twrench
