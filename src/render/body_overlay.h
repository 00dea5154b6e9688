#pragma once

#include <vector>

#include "render/label.h"
#include "render/sketch.h"
#include "render/theme.h"
#include "timeline/timeline.h"

namespace twrench {

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
  BodyOverlay(const Scene& scene, const Take& take, double radius);

  /// Returns the bounding radius in cm of everything that rotates with the body.
  double reach() const { return shows_axes_ ? axis_length * radius_ : radius_; }

  /// Returns further points that a camera should have in view at all times, in space, cm.
  std::vector<Eigen::Vector3d> extent() const;

  /// Adds the overlays at that instant to the draw lists for opaque and for translucent items.
  void draw(const Instant& instant, Sketch& solid, Sketch& sheer) const;

  std::vector<Label> labels(const Instant& instant, const Camera& camera, const Area& pane) const;

  /// Return the tips of the arrows in space, cm; for a body at rest they are at the origin.
  Eigen::Vector3d momentum_tip() const { return momentum_length * radius_ * up_; }
  Eigen::Vector3d omega_tip(const Sample& sample) const {
    return scale_ * (sample.X * sample.omega);
  }

  /// Returns the distance in cm from the centre of mass to the invariable plane.
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
  double trail_length_;  ///< Duration of the trail in s.
  Eigen::Vector3d trail_point_;
  Eigen::Vector3d up_;  ///< Unit vector L/|L| in space; 0 at rest.
  double scale_ = 0;    ///< Length in cm of omega's arrow for 1 rad/s.
  double plane_height_ = 0;
  double omega_radius_ = 0;  ///< Largest distance in cm of the tip of omega's arrow from L.
  double plane_radius_ = 0;  ///< Radius in cm of the plane's disc.
};

}  // namespace twrench
