#pragma once

#include <vector>

#include "picture/compose/element.h"
#include "picture/compose/layout.h"
#include "picture/hud/angle_scale.h"
#include "picture/look/theme.h"

namespace twrench::picture {

/// In a comparison of methods, the angles of the other motions from the recorded or the exact one,
/// or else the first, against time on a logarithmic scale: the past in full strength, the future
/// faint, with a cursor between them.
class AnglePanel : public Element {
 public:
  /// Uses layout.angle.
  AnglePanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
             const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

 private:
  canvas::Canvas::Point place(double time, double angle) const;
  void draw_curves(canvas::Canvas& canvas, double opacity) const;

  const OverlayColors& colors_;
  double duration_;        ///< Duration of the motion in s.
  double thickness_;       ///< Thickness of a curve in px.
  std::size_t reference_;  ///< Index of the motion from which the angles are.
  std::vector<std::vector<canvas::Canvas::Point>> curves_;  ///< That of the reference is empty.
  AngleScale scale_;
  Layer future_;
  Layer past_;
};

}  // namespace twrench::picture
