#pragma once

#include <twrench/motion/rotating_frame.h>

#include <vector>

#include "picture/overlay/draw_list.h"
#include "scene/scene.h"

namespace twrench::picture {

/// Stars at rest in space. For a camera that goes along with a turning frame they take the place of
/// the floor, and show how the world turns: as streaks, as long as the shutter is open.
class FixedStars {
 public:
  explicit FixedStars(const scene::Scene& scene);

  /// Adds the stars as `camera`, whose picture has that many pixels in height, sees them in
  /// `frame`.
  void draw(const motion::RotatingFrame& frame, const Camera& camera, int height,
            DrawList& translucent) const;

 private:
  struct Star {
    Eigen::Vector3d direction;  ///< Unit vector in space.
    double brightness;          ///< 0 to 1.
  };

  std::vector<Star> stars_;
  Color color_;
  double half_open_;  ///< Half the time in s of motion for which the shutter is open.
};

}  // namespace twrench::picture
