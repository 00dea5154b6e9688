#include "render/layout.h"

#include <algorithm>

namespace twrench {

Layout layout_of(const Scene& scene) {
  const auto [width, height] = std::pair(scene.film.width, scene.film.height);
  const int count = std::max(1, static_cast<int>(scene.overlay.compare.size()));
  const bool grid = count == 4;
  const int rows = grid || (height > width && count > 1) ? (grid ? 2 : count) : 1;
  const int columns = count / rows;
  Layout layout;
  for (int i = 0; i < count; ++i) {
    const int x = width * (i % columns) / columns;
    const int y = height * (i / columns) / rows;
    const Area area{x, y, width * (i % columns + 1) / columns - x,
                    height * (i / columns + 1) / rows - y};
    layout.panes.push_back({area, area});
  }
  return layout;
}

}  // namespace twrench
