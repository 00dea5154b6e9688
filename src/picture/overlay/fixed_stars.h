#pragma once

#include <twrench/motion/rotating_frame.h>

#include <vector>

#include "picture/overlay/draw_list.h"
#include "scene/scene.h"

namespace twrench::picture {

/// Stars at rest in space. If the camera moves with a rotating frame, they replace the floor and
/// show how the world turns: each is a streak as long as the shutter is open.
class FixedStars {
 public:
  explicit FixedStars(const scene::Scene& scene);

  /// Adds the stars as seen in `frame` by `camera`, whose picture is `height` pixels high.
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
