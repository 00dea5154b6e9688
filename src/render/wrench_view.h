#pragma once

#include "gl/framebuffer.h"
#include "render/body_overlay.h"
#include "render/body_pass.h"
#include "render/camera.h"
#include "render/element.h"
#include "render/floor.h"
#include "render/layout.h"
#include "render/screen_area.h"
#include "render/sketch_pass.h"

namespace twrench {

/// The body as it turns, seen by the scene's camera.
class WrenchView final : public SpaceView {
 public:
  /// The take with that index, drawn in `pane` by way of `framebuffer`, which has the film's size
  /// and outlives the view.
  WrenchView(const gl::Functions& gl, const gl::Framebuffer& framebuffer, const Scene& scene,
             const std::vector<Take>& takes, std::size_t take, const Layout::Pane& pane);

  std::vector<Layer> still() override;
  std::vector<PendingLayer> draw(const Moment& moment) override;
  std::vector<Label> labels(const Moment& moment) const override;

  Camera camera(double film_time) const override;

 private:
  ScreenArea covered(const Camera& camera, std::span<const Eigen::Matrix3d> poses) const;
  std::vector<gl::Readback> picture(const Camera& camera, const Eigen::Matrix3d& X,
                                    const ScreenArea& screen, std::span<const Area> areas);
  void draw_sharp(const Camera& camera, const Eigen::Matrix3d& X,
                  std::vector<PendingLayer>& layers);
  void draw_blurred(const Camera& camera, std::span<const Eigen::Matrix3d> poses,
                    std::vector<PendingLayer>& layers);

  const gl::Framebuffer& framebuffer_;
  int band_height_;  ///< rows of the picture that are cleared and read back together
  std::size_t take_;
  Layout::Pane pane_;
  double radius_;  ///< cm, of the sphere that holds the body in every pose
  BodyOverlay overlay_;
  CameraPath path_;  ///< from which the overlay is in view too
  BodyPass body_;
  bool multisampled_;  ///< else edges are smoothed one by one
  SketchPass sketch_pass_;
  Sketch solid_, sheer_;  ///< the overlay, as it is drawn in this frame
  std::optional<Floor> floor_;
  bool floor_lit_ = false;  ///< a flat background stays the colour it is
};

}  // namespace twrench
