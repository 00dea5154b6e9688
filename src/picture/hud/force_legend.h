#pragma once

#include "picture/compose/element.h"
#include "picture/compose/layout.h"
#include "picture/hud/text_block.h"

namespace twrench::picture {

/// The names of the forces in the colours of their arrows, in one row, with the frame in which they
/// act. If the row is too short, the frame is omitted; if it is still too short, everything is.
class ForceLegend : public Element {
 public:
  /// Uses layout.forces.
  ForceLegend(const scene::Scene& scene, const Layout& layout, const TextStyle& style);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

 private:
  Layer layer_;
};

}  // namespace twrench::picture
