#pragma once

#include <Eigen/Core>
#include <vector>

#include "picture/compose/label.h"
#include "picture/look/theme.h"
#include "picture/overlay/draw_list.h"
#include "timeline/tilting_torque.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// The torques that tilt the body further and those that tilt it back, as two arrows along a circle
/// about the axis of the tilt. Their lengths on the screen are proportional to the torques, in
/// every direction of the camera and to one scale for the film: if the circle is foreshortened, an
/// arrow covers a larger part of it.
///
/// The first starts at the longer end of the principal axis nearest to L, because the mass along
/// this axis tilts the body further; the second a quarter of a turn away, because the mass there
/// tilts it back. They turn in opposite directions and never meet.
class TorqueArcs {
 public:
  /// `radius` is the bounding radius of the body in every pose, in cm.
  TorqueArcs(const scene::Scene& scene, const timeline::Solution& solution, double radius);

  /// Returns the radius in cm of a sphere about the centre of mass that contains the arrows.
  double bounding_radius() const;

  /// Returns the length of an arrow in cm for 1 g cm^2/s^2, as seen at the distance of the centre
  /// of mass; 0 if there is never a torque.
  double scale() const { return scale_; }

  /// An arrow: points from its start to its tip in space, cm.
  struct Arc {
    std::vector<Eigen::Vector3d> path;
    Color color;
    bool is_further;  ///< Whether it tilts the body further.
  };

  /// Returns the arrows at that instant as a camera sees them whose picture fills `pane`, except
  /// those too short to be seen: the one that tilts the body further and the other.
  std::vector<Arc> arcs(const motion::Sample& sample, const Camera& camera,
                        const image::Area& pane) const;

  /// Adds the arrows, and the circle as a faint line.
  void draw(const motion::Sample& sample, const Camera& camera, const image::Area& pane,
            DrawList& opaque, DrawList& translucent) const;

  /// Returns the names of the groups of parts beside the arrows, if the scene shows names.
  std::vector<Label> labels(const motion::Sample& sample, const Camera& camera,
                            const image::Area& pane) const;

  /// The circle along which the arrows lie. Its centre is the centre of mass.
  struct Circle {
    Eigen::Vector3d start, quarter;  ///< Directions of its points at 0 and a quarter of a turn.
    double radius;                   ///< In cm.

    /// Returns the point at an angle in rad.
    Eigen::Vector3d at(double angle) const;
  };

 private:
  Circle circle(const motion::Sample& sample) const;

  timeline::TiltingTorque torque_;
  Color further_, back_, faint_;
  bool shows_labels_;
  double shaft_;  ///< In radii.
  double radius_;
  double scale_ = 0;
};

}  // namespace twrench::picture
