#pragma once

#include <Eigen/Core>
#include <functional>

#include "picture/overlay/draw_list.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// The look of the line that a point leaves behind.
struct TrackStyle {
  double width;         ///< In cm, at its newest end.
  double trail_length;  ///< Duration in s of motion.
  Color color;
  Color halo;  ///< Colour of the halo that keeps it visible on any background.
};

/// Adds the line that a point leaves behind during the trail of `instant`, and a dot at its current
/// position. `place` returns its position in space, cm.
void draw_track(const timeline::SolutionState& instant, const TrackStyle& style,
                const std::function<Eigen::Vector3d(const motion::Sample&)>& place,
                DrawList& translucent);

}  // namespace twrench::picture
