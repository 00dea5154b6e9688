#pragma once

#include "render/element.h"
#include "render/layout.h"
#include "render/principal_frame.h"
#include "render/sketch_pad.h"
#include "render/theme.h"

namespace twrench {

/// The momentum in the body frame. Its length G is constant, so it moves on a sphere, along a curve
/// of constant energy: around the axis of least or greatest moment or, close to the separatrix,
/// back and forth between the ends of the intermediate axis, which is the flip.
class MomentumView : public SpaceView {
 public:
  /// Shows one motion in `pane`, drawn through `framebuffer`, which must outlive the view.
  MomentumView(const gl::Functions& gl, const gl::Framebuffer& framebuffer, const Scene& scene,
               const std::vector<Take>& takes, std::size_t take, const Layout::Pane& pane);

  /// The sphere with its curves and axes, if the camera is fixed.
  std::vector<Layer> still() override;

  /// The momentum and its trail.
  std::vector<PendingLayer> draw(const Moment& moment) override;

  std::vector<Label> labels(const Moment& moment) const override;

  Camera camera(double film_time) const override;

  /// Returns the position of a sample's momentum, on the unit sphere unless the method has left it.
  Eigen::Vector3d place_of(const Sample& sample) const;

 private:
  void add_sphere();
  void add_level(const EnergyLevel& level, double width, const Ink& ink);
  void add_separatrix();
  void add_momentum(const Instant& instant);
  template <typename Place>
  void add_curve(Place place, double width, const Ink& ink);

  OverlayColors colors_;
  CameraPath path_;
  bool shows_trail_, shows_labels_;
  double trail_length_;  ///< Duration of the trail in s.
  std::size_t take_;
  FreeBody body_;
  PrincipalFrame frame_;
  Eigen::Matrix3d view_from_own_;  ///< From coordinates along the frame's axes to the picture's.
  Layout::Pane pane_;
  SketchPad pad_;
};

}  // namespace twrench
