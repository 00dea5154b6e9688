#pragma once

#include "render/element.h"
#include "render/layout.h"
#include "render/principal_frame.h"
#include "render/sketch_pad.h"
#include "render/theme.h"

namespace twrench {

/// Poinsot's construction: the inertia ellipsoid x . I x = 1, which turns with the body about its
/// fixed centre, rolls without slipping on the invariable plane. It touches the plane at
/// omega / sqrt(2T), which runs along the polhode on the ellipsoid and along the herpolhode on the
/// plane (Goldstein, Classical Mechanics, section 5.6).
///
/// Lengths here are multiples of the plane's distance sqrt(2T)/G from the centre, and L points up:
/// the plane is seen from above, with the contact under it.
class PoinsotView : public SpaceView {
 public:
  /// Of one take, drawn in `pane` by way of `framebuffer`, which outlives the view.
  PoinsotView(const gl::Functions& gl, const gl::Framebuffer& framebuffer, const Scene& scene,
              const std::vector<Take>& takes, std::size_t take, const Layout::Pane& pane);

  std::vector<PendingLayer> draw(const Moment& moment) override;
  std::vector<Label> labels(const Moment& moment) const override;

  Camera camera(double film_time) const override;

  /// The ellipsoid in the pose X: its principal radii, turned, as the image of the unit sphere.
  Eigen::Matrix3d ellipsoid(const Eigen::Matrix3d& X) const;

  /// Where it touches the plane, whose height is 1.
  Eigen::Vector3d contact(const Sample& sample) const;

 private:
  bool at_rest() const { return frame_.direction.isZero(0.0); }
  void add_grid(const Eigen::Matrix3d& view_from_unit);
  void add_polhode(const Eigen::Matrix3d& X);
  void add_plane(const Instant& instant);
  void add_ring(double radius, double width, const Ink& ink);

  OverlayColors colors_;
  CameraPath path_;
  bool shows_trail_, shows_labels_;
  double trail_length_;  ///< s
  std::size_t take_;
  FreeBody body_;
  PrincipalFrame frame_;
  Eigen::Matrix3d view_from_space_;
  double unit_;            ///< of omega, 2T/G, rad/s
  Eigen::Vector3d radii_;  ///< of the ellipsoid
  Annulus annulus_{0, 0};  ///< of the herpolhode
  double plane_radius_;
  std::vector<Eigen::Vector3d> herpolhode_;  ///< all of it, where it is not too dense to be seen
  Layout::Pane pane_;
  SketchPad pad_;
};

}  // namespace twrench
