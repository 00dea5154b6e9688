#pragma once

#include "picture/compose/layout.h"
#include "picture/hud/plot_panel.h"

namespace twrench::picture {

/// One component of X, x11, large, with a caption that explains it and a tick at each flip. It is
/// the cosine of the angle between the body's x axis and its direction at t = 0.
class CurvePanel final : public PlotPanel {
 public:
  CurvePanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
             const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors);

 private:
  void place_plot(const image::Area& area);
  void draw_caption(const scene::Scene& scene, const image::Area& area);
  void draw_scale(const scene::Scene& scene);
  void draw_arrow(double y, double direction);
  void label_flips(const std::vector<double>& times);

  const canvas::Font& font_;
  double size_;  ///< Size of all text, px per em.
  /// Whether there is room for the caption, for the scale on the left, and for the times of flips.
  bool captioned_ = false, scaled_ = false, timed_ = false;
};

}  // namespace twrench::picture
