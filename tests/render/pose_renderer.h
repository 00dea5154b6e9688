#pragma once

#include <set>

#include "render/renderer.h"

namespace twrench {

/// Returns the scene with only these features besides the body.
inline Scene showing(Scene scene, const std::set<Feature>& features) {
  scene.overlay.show = features;
  return scene;
}

/// Draws the body in any pose, bare or with some features.
class PoseRenderer {
 public:
  PoseRenderer(gl::Context& context, const Scene& scene, const std::set<Feature>& features = {})
      : timeline_(showing(scene, features), {0}),
        renderer_(context, showing(scene, features), timeline_.solutions()) {}

  /// With motion blur, as if it moved on from X as it does from its first pose.
  Image draw(const Eigen::Matrix3d& X) {
    FrameState state = timeline_.frame_state(0);
    for (Eigen::Matrix3d& pose : state.solutions[0].blur) {
      pose = pose * state.solutions[0].sample.X.transpose() * X;
    }
    state.solutions[0].sample.X = X;
    return renderer_.draw(state).image;
  }

  Camera camera() const { return renderer_.camera(0); }

 private:
  Timeline timeline_;
  Renderer renderer_;
};

}  // namespace twrench
