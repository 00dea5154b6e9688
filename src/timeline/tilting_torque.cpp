#include "timeline/tilting_torque.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "timeline/reference_frame.h"

namespace twrench::timeline {

TiltingTorque::TiltingTorque(const scene::Scene& scene, const motion::FreeBody& body)
    : frame_(scene.camera.frame), body_(body), tilt_(body) {
  const std::vector<body::Part> parts = scene::visible_parts(scene.body);
  for (const scene::PartGroup& group : scene::part_groups(scene.body)) {
    std::vector<body::PointMass>& points = groups_.emplace_back();
    for (const std::size_t i : group.parts) {
      std::ranges::copy(body::equimomental_points(parts[i]), std::back_inserter(points));
    }
  }
}

std::vector<double> TiltingTorque::on_groups(const motion::Sample& sample) const {
  const motion::RotatingFrame frame = reference_frame(frame_, body_, sample);
  const motion::FrameForces forces(frame, body_, sample);
  const Eigen::Vector3d axis = frame.attitude.transpose() * sample.X * tilt_.direction(sample);
  std::vector<double> torques;
  for (const std::vector<body::PointMass>& points : groups_) {
    double sum = 0;
    for (const auto& [mass, position] : points) {
      const motion::PointForces on = forces.on(mass, position);
      sum += axis.dot(on.position.cross(on.centrifugal + on.coriolis + on.euler));
    }
    torques.push_back(sum);
  }
  return torques;
}

}  // namespace twrench::timeline
