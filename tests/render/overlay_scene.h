#pragma once

#include <algorithm>
#include <vector>

#include "canvas/font.h"
#include "render/layer.h"
#include "render/layout.h"
#include "render/t_wrench.h"
#include "render/theme.h"
#include "timeline/timeline.h"

namespace twrench {

/// A scene with text, and everything its elements are created from.
struct OverlayScene {
  explicit OverlayScene(const Scene& film, int frame = 0)
      : scene(film),
        layout(layout_of(scene)),
        timeline(scene, {frame}),
        typeface(load_typeface(scene.overlay.font)) {}

  Scene scene;
  Layout layout;
  Timeline timeline;
  Typeface typeface;
  const OverlayColors& colors = style_of(scene.look.theme).overlay;
};

inline Scene film_of(int width, int height, const std::string& title = "The Dzhanibekov effect") {
  Scene scene = t_wrench(width, height);
  scene.title = title;
  return scene;
}

inline bool same(const std::vector<Layer>& a, const std::vector<Layer>& b) {
  return std::ranges::equal(a, b, [](const Layer& one, const Layer& other) {
    return one.area() == other.area() && one.image.pixels == other.image.pixels;
  });
}

}  // namespace twrench
