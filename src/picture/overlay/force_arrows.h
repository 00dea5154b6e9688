#pragma once

#include <twrench/motion/rotating_frame.h>

#include <Eigen/Core>
#include <vector>

#include "picture/look/force_style.h"
#include "picture/overlay/draw_list.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// The forces on the parts of the body in the scene's frame of reference, as arrows that start at
/// its equimomental points. All arrows of a film have one scale.
///
/// For each part, the points on its long axes are shown: the middles of a rod's ends, four on a
/// disc, six in a ball. A small part is shown as one point.
class ForceArrows {
 public:
  /// `radius` is the bounding radius of the body in every pose, in cm.
  ForceArrows(const scene::Scene& scene, const timeline::Solution& solution, double radius);

  /// Returns the tips of the film's arrows, along the axes of the frame, in cm.
  const std::vector<Eigen::Vector3d>& extent() const { return extent_; }

  /// Returns the length in cm of the arrow for 1 dyn; 0 if no force ever acts.
  double scale() const { return scale_; }

  /// A mass whose forces are shown. Lengths in cm, in body axes.
  struct Point {
    body::PointMass mass;
    Eigen::Vector3d start;  ///< Start of its arrows: just off the end of a rod.
    double clearance;       ///< Distance from there to the arrows, each in its own direction.
  };
  const std::vector<Point>& points() const { return points_; }

  /// Adds the arrows at that instant, except those too short to be seen.
  void draw(const timeline::SolutionState& instant, DrawList& opaque) const;

 private:
  template <typename Visit>
  void visit(const motion::RotatingFrame& frame, const motion::Sample& sample, Visit visit) const;

  OverlayColors colors_;
  bool is_dimmed_;
  double shaft_;  ///< In radii.
  scene::Frame frame_;
  std::vector<Force> forces_;
  motion::FreeBody body_;
  double radius_;
  std::vector<Point> points_;
  double scale_ = 0;
  std::vector<Eigen::Vector3d> extent_;
};

}  // namespace twrench::picture
