#pragma once

#include <vector>

#include "canvas/canvas.h"
#include "picture/compose/element.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"

namespace twrench::picture {

/// The principal moments as bars, from the least to the greatest, in the colours of their axes. A
/// turning arrow marks the axis about which the body rotates, and its bar is in full strength.
class MomentsPanel : public Element {
 public:
  /// Uses layout.moments. Shows the first solution's body.
  MomentsPanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
               const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

 private:
  Layer layer_;
};

}  // namespace twrench::picture
