#pragma once

#include <optional>
#include <vector>

#include "picture/compose/label.h"
#include "picture/look/theme.h"
#include "picture/overlay/draw_list.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// The overlays shown in space around the rotating body, as selected by the scene: the body's axes,
/// L and omega, the invariable plane, and the trail of a point.
///
/// This is Poinsot's picture without the ellipsoid. Since omega . L is constant, omega's tip stays
/// on a plane normal to L, the invariable plane, if omega always has the same scale. The scale
/// places this plane just outside the body's bounding sphere, or closer if omega would become too
/// long. L, whose length has no meaningful comparison, pierces the plane and ends beyond it.
class BodyOverlay {
 public:
  /// `radius` is the bounding radius of the body in every pose, in cm.
  BodyOverlay(const scene::Scene& scene, const motion::FreeBody& body, double radius);

  /// Returns the bounding radius in cm of everything that rotates with the body.
  double bounding_radius() const { return shows_axes_ ? axis_arrow_length() : radius_; }

  /// Returns further points that a camera should have in view at all times, in space, cm.
  std::vector<Eigen::Vector3d> extent() const;

  /// Adds the overlays at that instant to the draw lists for opaque and for translucent items.
  void draw(const timeline::SolutionState& instant, DrawList& opaque, DrawList& translucent) const;

  std::vector<Label> labels(const timeline::SolutionState& instant, const Camera& camera,
                            const image::Area& pane) const;

  /// Return the tips of the arrows in space, cm. If the body is at rest, they are at the origin.
  Eigen::Vector3d momentum_tip() const { return momentum_length * radius_ * up_; }
  Eigen::Vector3d omega_tip(const motion::Sample& sample) const {
    return scale_ * (sample.X * sample.omega);
  }

  /// Return the length of the axes' arrows, and the radii of the shafts of all arrows, in cm.
  double axis_arrow_length() const { return axis_length * radius_; }
  double axis_shaft() const { return axis_shaft_ * radius_; }
  double momentum_shaft() const { return momentum_shaft_ * radius_; }
  double omega_shaft() const { return omega_shaft_ * radius_; }
  double omega_nearer(const motion::Sample& sample) const;

  /// Returns the distance in cm from the centre of mass to the invariable plane.
  double plane_height() const { return plane_height_; }

 private:
  // As multiples of the radius.
  static constexpr double axis_length = 1.16;
  static constexpr double momentum_length = 1.42;

  void draw_plane(DrawList& translucent) const;
  void draw_ellipsoid(const Eigen::Matrix3d& X, DrawList& translucent) const;
  void draw_trail(const timeline::SolutionState& instant, DrawList& translucent) const;

  OverlayColors colors_;
  /// The ellipsoid of equal inertia, if it is shown.
  std::optional<body::Part> ellipsoid_;
  bool shows_axes_, shows_momentum_, shows_omega_, shows_plane_, shows_trail_, shows_labels_;
  double momentum_shaft_, omega_shaft_, axis_shaft_, trail_width_;  ///< In radii.
  double radius_;
  double trail_length_;  ///< Duration of the trail in s.
  Eigen::Vector3d trail_point_;
  Eigen::Vector3d up_;  ///< Unit vector L/|L| in space; 0 at rest.
  double scale_ = 0;    ///< Length in cm of omega's arrow for 1 rad/s.
  /// Largest length in cm of omega's arrow, if the body is not rigid; otherwise 0.
  double omega_reach_ = 0;
  double plane_height_ = 0;
  double omega_radius_ = 0;  ///< Largest distance in cm of the tip of omega's arrow from L.
  double plane_radius_ = 0;  ///< Radius in cm of the plane's disc.
};

}  // namespace twrench::picture
