#pragma once

#include "render/renderer.h"

namespace twrench {

/// The scene with nothing shown beside the body.
inline Scene bare(Scene scene) {
  scene.overlay.show.clear();
  return scene;
}

/// Draws the bare body in any pose.
class PoseRenderer {
 public:
  PoseRenderer(gl::Context& context, const Scene& scene)
      : timeline_(bare(scene), {0}), renderer_(context, bare(scene), timeline_.takes()) {}

  Image draw(const Eigen::Matrix3d& X) {
    Moment moment = timeline_.moment(0);
    moment.instants[0].sample.X = X;
    return renderer_.draw(moment).image;
  }

  Camera camera() const { return renderer_.camera(0); }

 private:
  Timeline timeline_;
  Renderer renderer_;
};

}  // namespace twrench
