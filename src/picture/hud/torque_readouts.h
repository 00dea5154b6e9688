#pragma once

#include "picture/compose/element.h"
#include "picture/hud/text_block.h"

namespace twrench::picture {

/// The torque with which the forces on each group of parts tilt the body further, and the sum of
/// these torques. A viewer sees which group wins.
class TorqueReadouts : public Element {
 public:
  /// Uses layout.torques. Shows the first solution.
  TorqueReadouts(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                 const Layout& layout, const TextStyle& style);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

 private:
  TextBlock block_;
};

}  // namespace twrench::picture
