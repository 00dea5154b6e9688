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

/// The rotating body, seen by the scene's camera.
class WrenchView final : public SpaceView {
 public:
  /// Shows the motion with that index in `pane`, drawn through `framebuffer`, which has the frame
  /// size and must outlive the view.
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
  int band_height_;  ///< Rows of the picture that are cleared and read back together.
  std::size_t take_;
  Layout::Pane pane_;
  double radius_;  ///< Bounding radius of the body in every pose, in cm.
  BodyOverlay overlay_;
  CameraPath path_;  ///< Chosen so that the overlay is in view too.
  BodyPass body_;
  bool multisampled_;  ///< Otherwise edges are antialiased analytically.
  SketchPass sketch_pass_;
  Sketch solid_, sheer_;  ///< Draw lists of the overlay in the current frame.
  std::optional<Floor> floor_;
  bool floor_lit_ = false;  ///< Whether the floor is lit; a flat background keeps its colour.
};

}  // namespace twrench
