#pragma once

#include "picture/compose/layout.h"
#include "picture/hud/plot_panel.h"

namespace twrench::picture {

/// The component of one body axis along its direction at t = 0, large, with a caption that explains
/// it and a tick at each flip. The axis is the one that turns over or, if none does, the principal
/// axis nearest to L. For a body axis that starts along its space axis, it is x11, x22 or x33.
class CurvePanel final : public PlotPanel {
 public:
  CurvePanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
             const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors);

 private:
  void place_plot(const image::Area& area, const timeline::Solution& solution);
  void draw_caption(const scene::Scene& scene, const image::Area& area);
  void draw_scale(const scene::Scene& scene);
  void draw_arrow(double y, double direction);
  void label_flips(const std::vector<double>& times);

  const canvas::Font& font_;
  double size_;  ///< Size of all text, px per em.
  /// Name of the axis, see scene::axis_name().
  std::string axis_;
  /// Whether there is room for the caption, for the scale on the left, and for the times of flips.
  bool captioned_ = false, scaled_ = false, timed_ = false;
};

}  // namespace twrench::picture
