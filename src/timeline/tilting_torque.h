#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/motion/stability.h>

#include <vector>

#include "scene/scene.h"

namespace twrench::timeline {

/// The torque with which the centrifugal, Coriolis and Euler forces on each group of parts increase
/// the body's tilt against L. Its axis is that of the tilt, through the centre of mass.
class TiltingTorque {
 public:
  TiltingTorque(const scene::Scene& scene, const motion::FreeBody& body);

  /// Returns the torque in g cm^2/s^2 on each group of scene::part_groups(); negative if it pulls
  /// the body back.
  std::vector<double> on_groups(const motion::Sample& sample) const;

 private:
  scene::Frame frame_;
  motion::FreeBody body_;
  motion::Tilt tilt_;
  std::vector<std::vector<body::PointMass>> groups_;
};

}  // namespace twrench::timeline
