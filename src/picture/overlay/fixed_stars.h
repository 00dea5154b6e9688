#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "picture/overlay/draw_list.h"
#include "scene/scene.h"

namespace twrench::picture {

/// Stars at rest in space. In a camera that turns they are streaks along the circles in which they
/// are seen to move.
class FixedStars {
 public:
  /// The stars of the scene's theme or, if it has none, fainter ones that replace the floor. A
  /// picture is `height` pixels high.
  FixedStars(const scene::Scene& scene, int height);

  /// Returns whether the theme has stars that are visible on the scene's background.
  static bool are_of_theme(const scene::Scene& scene);

  /// The turning of a camera. Each rotation takes the direction in which a star is seen now to that
  /// in which it was seen at another time.
  struct Turning {
    /// At least one, in order of time.
    std::vector<Eigen::Matrix3d> rotations;
    /// Whether the earliest are faint. If not, a streak has as much light as a dot, as on a
    /// photograph.
    bool fades = false;
  };

  /// Adds the stars as seen by `camera` while it turns.
  void draw(const Camera& camera, const Turning& turning, DrawList& translucent) const;

 private:
  struct Dot {
    Eigen::Vector3d direction;  ///< Unit vector in space.
    double width;               ///< In pixels.
    Ink ink;
  };

  void add_sky(int count, int height);
  void add_spiral(const Color& color, int height);

  std::vector<Dot> dots_;
};

}  // namespace twrench::picture
