#pragma once

#include <algorithm>
#include <vector>

#include "canvas/font.h"
#include "picture/compose/layer.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"
#include "picture/t_wrench.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// A scene with text, and everything its elements are created from.
struct OverlayScene {
  explicit OverlayScene(const scene::Scene& film, int frame = 0)
      : scene(film),
        layout(compute_layout(scene)),
        timeline(scene, {frame}),
        typeface(canvas::load_typeface(scene.overlay.font)) {}

  scene::Scene scene;
  Layout layout;
  timeline::Timeline timeline;
  canvas::Typeface typeface;
  const OverlayColors& colors = style_of(scene.look.theme).overlay;
};

inline scene::Scene film_of(int width, int height,
                            const std::string& title = "The Dzhanibekov effect") {
  scene::Scene scene = t_wrench(width, height);
  scene.title = title;
  return scene;
}

inline bool same(const std::vector<Layer>& a, const std::vector<Layer>& b) {
  return std::ranges::equal(a, b, [](const Layer& one, const Layer& other) {
    return one.area() == other.area() && one.image.pixels == other.image.pixels;
  });
}

}  // namespace twrench::picture
