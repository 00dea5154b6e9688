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
        renderer_(context, showing(scene, features), timeline_.takes()) {}

  /// With motion blur, as if it moved on from X as it does from its first pose.
  Image draw(const Eigen::Matrix3d& X) {
    Moment moment = timeline_.moment(0);
    for (Eigen::Matrix3d& pose : moment.instants[0].blur) {
      pose = pose * moment.instants[0].sample.X.transpose() * X;
    }
    moment.instants[0].sample.X = X;
    return renderer_.draw(moment).image;
  }

  Camera camera() const { return renderer_.camera(0); }

 private:
  Timeline timeline_;
  Renderer renderer_;
};

}  // namespace twrench
