#include "picture/hud/component_panel.h"

#include <algorithm>
#include <cmath>

namespace twrench::picture {

ComponentPanel::ComponentPanel(const scene::Scene& scene,
                               const std::vector<timeline::Solution>& solutions,
                               const Layout& layout, const canvas::Typeface& typeface,
                               const OverlayColors& colors)
    : PlotPanel(scene, solutions, *layout.components, std::max(1.0, 0.09 * layout.text.caption),
                colors) {
  place_plots(*layout.components, layout.text.caption);
  draw_names(layout.text.caption, typeface);
  mark_zeros();
  if (!compares()) mark_flips(solutions[0]);
  add_curves(solutions);
}

void ComponentPanel::place_plots(const image::Area& area, double label_size) {
  const int columns = is_strip(area) ? 9 : 3;
  const int rows = 9 / columns;
  const int gap = std::max(2, static_cast<int>(0.7 * label_size));
  const int label = static_cast<int>(std::ceil(1.25 * label_size));
  const image::Area inner{area.x + gap, area.y + gap / 2, area.width - 2 * gap,
                          area.height - gap / 2};
  for (int i = 0; i < 9; ++i) {
    const int column = i % columns;
    const int row = i / columns;
    const int left = inner.x + column * (inner.width + gap) / columns;
    const int right = inner.x + (column + 1) * (inner.width + gap) / columns - gap;
    const int top = inner.y + row * inner.height / rows + label;
    const int bottom = inner.y + (row + 1) * inner.height / rows - gap;
    if (right <= left || bottom <= top) continue;
    plots_.push_back(component(i / 3, i % 3, {left, top, right - left, bottom - top}));
  }
}

void ComponentPanel::draw_names(double size, const canvas::Typeface& typeface) {
  canvas::Canvas canvas = ground();
  for (const Plot& plot : plots_) {
    const Color color = compares() ? colors_.dim : ink(plot, 0);
    canvas.text(canvas::typeset(typeface.regular, name_of(plot)), size,
                {static_cast<double>(plot.area.x), plot.area.y - 0.35 * size}, {color});
  }
}

}  // namespace twrench::picture
