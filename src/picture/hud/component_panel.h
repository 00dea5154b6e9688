#pragma once

#include "picture/compose/layout.h"
#include "picture/hud/plot_panel.h"

namespace twrench::picture {

/// The nine components of X, arranged as in the matrix or, if there is little height, in a row.
class ComponentPanel final : public PlotPanel {
 public:
  ComponentPanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                 const Layout& layout, const canvas::Typeface& typeface,
                 const OverlayColors& colors);

 private:
  void place_plots(const image::Area& area, double label_size);
  void draw_names(double size, const canvas::Typeface& typeface);
};

}  // namespace twrench::picture
