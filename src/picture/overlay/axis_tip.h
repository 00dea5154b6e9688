#pragma once

#include <Eigen/Core>
#include <vector>

#include "picture/look/force_style.h"
#include "picture/overlay/draw_list.h"
#include "timeline/timeline.h"
#include "timeline/tip_forces.h"

namespace twrench::picture {

/// The principal axis about which the body rotates, with the path of its tip and the forces on it
/// (timeline::TipForces): the centrifugal and the Coriolis force and, thicker, their sum, as arrows
/// that explain why the path stays near L or runs away. All arrows of a pane have one scale, at
/// which an arrow towards L does not reach beyond it unless the path stays very close. A dot marks
/// the direction of L at the tip's distance.
class AxisTip {
 public:
  /// `radius` is the bounding radius of the body in every pose, in cm.
  AxisTip(const scene::Scene& scene, const timeline::Solution& solution, double radius);

  /// Returns the tips of the film's arrows, along the axes of the rotating frame, in cm.
  const std::vector<Eigen::Vector3d>& extent() const { return extent_; }

  /// Returns the distance in cm of the tip from the centre of mass.
  double distance() const;

  /// Returns the length of an arrow in cm for 1 dyn at the tip; 0 if there is never a force.
  double scale() const { return scale_; }

  /// Adds the axis, the path and the arrows at that instant, except arrows too short to be seen.
  /// The samples of its trail are seen in the rotating frame.
  void draw(const timeline::SolutionState& instant, DrawList& opaque, DrawList& translucent) const;

 private:
  timeline::TipForces forces_;
  std::vector<Force> shown_;
  OverlayColors colors_;
  bool is_dimmed_;
  double thickness_;
  double trail_length_;  ///< In s.
  double radius_;
  Eigen::Vector3d up_;  ///< Unit vector L/|L| in space; 0 at rest.
  double scale_ = 0;
  std::vector<Eigen::Vector3d> extent_;
};

}  // namespace twrench::picture
