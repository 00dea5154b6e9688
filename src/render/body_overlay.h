#pragma once

#include <vector>

#include "render/label.h"
#include "render/sketch.h"
#include "render/theme.h"
#include "timeline/timeline.h"

namespace twrench {

/// What is shown in space beside the turning body, where the scene says so: the axes of the body,
/// L and omega, the invariable plane, the trail of a point.
///
/// It is Poinsot's picture without the ellipsoid. omega . L is constant, so that with one scale for
/// all omega its tip stays on a plane normal to L, the invariable one. The scale is such that this
/// plane stands just outside the sphere that holds the body, or nearer where omega would get too
/// long. L, whose length says nothing that one could compare, pierces the plane and ends beyond.
class BodyOverlay {
 public:
  /// `radius` in cm, of the sphere that holds the body in every pose.
  BodyOverlay(const Scene& scene, const Take& take, double radius);

  /// cm, of the sphere that holds what turns with the body.
  double reach() const { return shows_axes_ ? axis_length * radius_ : radius_; }

  /// What else a camera should have in view, at any time; space, cm.
  std::vector<Eigen::Vector3d> extent() const;

  /// Adds what is shown at that instant.
  void draw(const Instant& instant, Sketch& solid, Sketch& sheer) const;

  std::vector<Label> labels(const Instant& instant, const Camera& camera, const Area& pane) const;

  /// The ends of the arrows, space, cm; those at rest are at the origin.
  Eigen::Vector3d momentum_tip() const { return momentum_length * radius_ * up_; }
  Eigen::Vector3d omega_tip(const Sample& sample) const {
    return scale_ * (sample.X * sample.omega);
  }

  /// cm, from the centre of mass to the invariable plane.
  double plane_height() const { return plane_height_; }

 private:
  // As multiples of the radius.
  static constexpr double axis_length = 1.16;
  static constexpr double momentum_length = 1.42;

  void draw_plane(Sketch& sheer) const;
  void draw_trail(const std::vector<Sample>& trail, Sketch& sheer) const;
  template <typename Place>
  void draw_fading(const std::vector<Sample>& trail, double width, const Color& color, Place place,
                   Sketch& sheer) const;

  OverlayColors colors_;
  bool shows_axes_, shows_momentum_, shows_omega_, shows_plane_, shows_trail_, shows_labels_;
  double radius_;
  double trail_length_;  ///< s
  Eigen::Vector3d trail_point_;
  Eigen::Vector3d up_;  ///< L/|L|, space; 0 at rest
  double scale_ = 0;    ///< cm of omega's arrow for 1 rad/s
  double plane_height_ = 0;
  double omega_radius_ = 0;  ///< cm, how far from L the tip of omega's arrow goes
  double plane_radius_ = 0;  ///< cm, of the plane's disc
};

}  // namespace twrench
