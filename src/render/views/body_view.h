#pragma once

#include "gl/framebuffer.h"
#include "render/body/body_pass.h"
#include "render/body/floor.h"
#include "render/compose/element.h"
#include "render/compose/layout.h"
#include "render/overlay/body_overlay.h"
#include "render/overlay/draw_list_pass.h"
#include "render/overlay/fixed_stars.h"
#include "render/overlay/force_arrows.h"
#include "render/space/camera.h"
#include "render/space/screen_area.h"
#include "render/views/blur_sampling.h"

namespace twrench::render {

/// The rotating body, seen by the scene's camera, which may go along with a turning frame: a trail
/// is then the path in that frame, and motion blur is that of the motion in it.
class BodyView final : public SpaceView {
 public:
  /// Shows the motion with that index in `pane`, drawn through `framebuffer`, which has the frame
  /// size and must outlive the view.
  BodyView(const gl::Functions& gl, const gl::Framebuffer& framebuffer, const scene::Scene& scene,
           const std::vector<timeline::Solution>& solutions, std::size_t solution,
           const Layout::Pane& pane);

  std::vector<Layer> static_layers() override;
  std::vector<PendingLayer> draw(const timeline::FrameState& state) override;
  std::vector<Label> labels(const timeline::FrameState& state) const override;

  Camera camera(double video_time) const override;

 private:
  Camera own_camera_in_space(const timeline::FrameState& state) const override;
  void add_surroundings(const gl::Functions& gl, const scene::Scene& scene);
  motion::RotatingFrame frame_at(const motion::Sample& sample) const;
  timeline::SolutionState relative(timeline::SolutionState instant) const;
  Framing framing_of(const scene::Scene& scene, const timeline::Solution& solution) const;
  ScreenArea covered(const Camera& camera, std::span<const Eigen::Matrix3d> poses) const;
  std::vector<gl::Readback> picture(const Camera& camera, const Eigen::Matrix3d& X,
                                    const ScreenArea& screen, std::span<const image::Area> areas);
  void draw_sharp(const Camera& camera, const Eigen::Matrix3d& X,
                  std::vector<PendingLayer>& layers);
  void draw_blurred(const Camera& camera, std::span<const Eigen::Matrix3d> poses,
                    std::vector<PendingLayer>& layers);

  const gl::Framebuffer& framebuffer_;
  int band_height_;  ///< Rows of the picture that are cleared and read back together.
  std::size_t solution_;
  motion::FreeBody motion_;
  scene::Frame frame_;
  Layout::Pane pane_;
  double radius_;  ///< Bounding radius of the body in every pose, in cm.
  BodyOverlay overlay_;
  std::optional<ForceArrows> forces_;
  scene::CameraPath path_;
  Framing framing_;  ///< Chosen so that the overlay is in view too; its direction moves.
  BodyPass body_;
  bool multisampled_;  ///< Otherwise edges are antialiased analytically.
  DrawListPass draw_list_pass_;
  std::optional<BlurSampling> sampling_;  ///< With motion blur.
  DrawList opaque_, translucent_;         ///< Draw lists of the overlay in the current frame.
  std::optional<Floor> floor_;            ///< For a camera at rest in space; otherwise
  std::optional<FixedStars> stars_;       ///< these show how the world turns.
  bool floor_lit_ = false;  ///< Whether the floor is lit; a flat background keeps its colour.
};

}  // namespace twrench::render
