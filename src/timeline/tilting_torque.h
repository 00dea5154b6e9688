#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/motion/stability.h>

#include <algorithm>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::timeline {

/// The torques with which the centrifugal and Coriolis forces in the rotating frame
/// (motion::steady_frame) change the tilt of a body against L. Their axis is that of the tilt,
/// through the centre of mass.
///
/// The forces on a group of parts may also have a torque that does not need a tilt: in a steady
/// rotation the rest of the body holds the group against it, and over the whole body these torques
/// cancel. They are not included.
class TiltingTorque {
 public:
  TiltingTorque(const scene::Scene& scene, const motion::FreeBody& body);

  /// The torque on a group of parts in g cm^2/s^2: positive if it increases the tilt.
  struct GroupTorque {
    std::string name;
    double torque;
  };

  /// The torques that tilt the body further (at least 0) and those that tilt it back (at most 0),
  /// in g cm^2/s^2.
  struct Sides {
    double further = 0, back = 0;
    double sum() const { return further + back; }
    double larger() const { return std::max(further, -back); }
  };

  /// The axes of the tilt, unit vectors in body axes; all 0 if the body is not tilted.
  struct Axes {
    Eigen::Vector3d about;  ///< The body tilts further if it turns about this axis, right-handed.
    Eigen::Vector3d spin;   ///< The end of the principal axis that is nearest to L.
    Eigen::Vector3d lean;   ///< The direction in which this end leans away from L.
  };

  /// Returns whether the groups of scene::part_groups() are compared. If one of them makes up
  /// nearly the whole body, its point masses (body::equimomental_points) are compared instead,
  /// which have no names.
  bool compares_groups() const { return compares_groups_; }

  /// Returns the torque on each group; nothing unless groups are compared.
  std::vector<GroupTorque> on_groups(const motion::Sample& sample) const;

  /// Returns the sums of the positive and of the negative torques.
  Sides sides(const motion::Sample& sample) const;

  /// Names of groups of parts, separated by commas. Empty unless groups are compared.
  struct SideNames {
    std::string further, back;
  };

  /// Returns the names of the groups that contribute to each side.
  SideNames names(const motion::Sample& sample) const;

  /// Returns the largest torque on a side in these samples; 0 if there are only rounding errors.
  double strongest(const std::vector<motion::Sample>& samples) const;

  Axes axes(const motion::Sample& sample) const;

  /// Returns the end of the axis on which the body reaches farther, a unit vector in body axes. If
  /// both are alike, it is the one nearer to L at t = 0.
  const Eigen::Vector3d& longer_end() const { return longer_end_; }

 private:
  /// A part of the mass, and the integral of r r^T over it in g cm^2, body axes.
  struct Element {
    std::string name;
    Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
  };

  std::vector<double> on_elements(const motion::Sample& sample) const;

  motion::FreeBody body_;
  motion::Tilt tilt_;
  std::vector<Element> elements_;
  bool compares_groups_;
  Eigen::Vector3d longer_end_;
};

}  // namespace twrench::timeline
