#pragma once

#include <set>

#include "draw/renderer.h"

namespace twrench::draw {

/// Returns the scene with the body and only these features.
inline scene::Scene showing(scene::Scene scene, const std::set<scene::Feature>& features) {
  scene.overlay.show = features;
  return scene;
}

/// Draws the body in any pose, bare or with some features.
class PoseRenderer {
 public:
  PoseRenderer(gl::Context& context, const scene::Scene& scene,
               const std::set<scene::Feature>& features = {})
      : timeline_(showing(scene, features), {0}),
        renderer_(context, showing(scene, features), timeline_.solutions()) {}

  /// With motion blur, the body moves on from X as it does from its first pose.
  image::Image draw(const Eigen::Matrix3d& X) {
    timeline::FrameState state = timeline_.frame_state(0);
    for (motion::Sample& sample : state.solutions[0].blur) {
      sample.X = sample.X * state.solutions[0].sample.X.transpose() * X;
    }
    state.solutions[0].sample.X = X;
    return renderer_.draw(state).image;
  }

  picture::Camera camera() const { return renderer_.camera(timeline_.frame_state(0)); }

 private:
  timeline::Timeline timeline_;
  Renderer renderer_;
};

}  // namespace twrench::draw
