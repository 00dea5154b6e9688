#pragma once

#include "gl/framebuffer.h"
#include "render/body_pass.h"
#include "render/camera.h"
#include "render/element.h"
#include "render/layout.h"

namespace twrench {

/// The body as it turns, seen by the scene's camera.
class WrenchView : public Element {
 public:
  /// The take with that index, drawn in `pane` by way of `framebuffer`, which has the film's size
  /// and outlives the view.
  WrenchView(const gl::Functions& gl, const gl::Framebuffer& framebuffer, const Scene& scene,
             std::size_t take, const Layout::Pane& pane);

  std::vector<Layer> draw(const Moment& moment) override;

  /// `film_time` in s: the camera may move.
  Camera camera(double film_time) const;

 private:
  const gl::Functions& gl_;
  const gl::Framebuffer& framebuffer_;
  CameraPath path_;
  std::size_t take_;
  Layout::Pane pane_;
  double radius_;  ///< cm, of the sphere that holds the body in every pose
  Mesh mesh_;
  BodyPass body_;
};

}  // namespace twrench
