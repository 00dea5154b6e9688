#include "picture/hud/panel.h"

#include <algorithm>

namespace twrench::picture {

void draw_panel(canvas::Canvas& canvas, const image::Area& area, double radius,
                const OverlayColors& colors) {
  canvas.panel(area, std::min(radius, 0.1 * std::min(area.width, area.height)),
               {colors.panel, colors.panel_opacity});
}

image::Area panel_content(const image::Area& panel, double size) {
  const auto padding = static_cast<int>(0.8 * size);
  return {panel.x + padding, panel.y + padding, std::max(1, panel.width - 2 * padding),
          std::max(1, panel.height - 2 * padding)};
}

}  // namespace twrench::picture
