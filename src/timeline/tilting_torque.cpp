#include "timeline/tilting_torque.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace twrench::timeline {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double nearly_whole = 0.95;  // of the second moments of the body
constexpr double rounding = 1e-9;      // of the largest possible torque
constexpr double contribution = 0.02;  // of the larger side, of a group that is named
constexpr double alike = 1e-6;         // of the distances of two ends

Matrix3d second_moment(const body::PointMass& point) {
  return point.mass * point.position * point.position.transpose();
}

}  // namespace

TiltingTorque::TiltingTorque(const scene::Scene& scene, const motion::FreeBody& body)
    : body_(body), tilt_(body) {
  const std::vector<body::Part> parts = scene::massive_parts(scene.body);
  std::vector<Element> points;
  Matrix3d whole = Matrix3d::Zero();
  Vector3d end = body.principal().axes.col(tilt_.axis());
  if (end.dot(body.inertia() * body.omega()) < 0) end = -end;
  double nearer_reach = 0, other_reach = 0;
  for (const scene::PartGroup& group : scene::part_groups(scene.body, scene.language)) {
    Element& element = elements_.emplace_back(Element{.name = group.name});
    for (const std::size_t i : group.parts) {
      for (const body::PointMass& point : body::equimomental_points(parts[i])) {
        points.push_back({{}, second_moment(point)});
        element.second_moment += points.back().second_moment;
        nearer_reach = std::max(nearer_reach, end.dot(point.position));
        other_reach = std::max(other_reach, -end.dot(point.position));
      }
    }
    whole += element.second_moment;
  }
  longer_end_ = other_reach > (1 + alike) * nearer_reach ? Vector3d(-end) : end;
  compares_groups_ = std::ranges::none_of(elements_, [&](const Element& element) {
    return element.second_moment.trace() > nearly_whole * whole.trace();
  });
  if (!compares_groups_) elements_ = std::move(points);
}

TiltingTorque::Axes TiltingTorque::axes(const motion::Sample& sample) const {
  const Vector3d about = tilt_.direction(sample);
  if (about.isZero(0.0)) return {about, about, about};
  Vector3d spin = body_.principal().axes.col(tilt_.axis());
  if (spin.dot(body_.inertia() * sample.omega) < 0) spin = -spin;
  return {about, spin, about.cross(spin)};
}

/// With the frame's angular velocity f and the body's w relative to it, the centrifugal forces on a
/// mass with the second moment S = sum of M r r^T have the torque f x S f, and the Coriolis forces
/// 2 w x S f. The centrifugal torque about the axis of the tilt is, for a tilt e and S in the axes
/// of spin and lean, f^2 (1/2 sin(2 e) (Sss - Sll) + cos(2 e) Ssl). The last term remains without a
/// tilt; the sum of Ssl over the body is 0.
std::vector<double> TiltingTorque::on_elements(const motion::Sample& sample) const {
  const auto [about, spin, lean] = axes(sample);
  const Vector3d up = (body_.inertia() * sample.omega).stableNormalized();
  const double rate = tilt_.steady_rate(), along = up.dot(spin), across = up.dot(lean);
  const Vector3d f = rate * up;
  const double steady = rate * rate * (along * along - across * across);
  std::vector<double> torques;
  for (const Element& element : elements_) {
    const Matrix3d& S = element.second_moment;
    torques.push_back(about.dot((2 * sample.omega - f).cross(S * f)) - steady * spin.dot(S * lean));
  }
  return torques;
}

std::vector<TiltingTorque::GroupTorque> TiltingTorque::on_groups(
    const motion::Sample& sample) const {
  std::vector<GroupTorque> groups;
  if (!compares_groups_) return groups;
  const std::vector<double> torques = on_elements(sample);
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    groups.push_back({elements_[i].name, torques[i]});
  }
  return groups;
}

TiltingTorque::Sides TiltingTorque::sides(const motion::Sample& sample) const {
  Sides sides;
  for (const double torque : on_elements(sample)) {
    (torque > 0 ? sides.further : sides.back) += torque;
  }
  return sides;
}

TiltingTorque::SideNames TiltingTorque::names(const motion::Sample& sample) const {
  SideNames names;
  const double least = contribution * sides(sample).larger();
  for (const auto& [name, torque] : on_groups(sample)) {
    if (!(std::abs(torque) > least)) continue;
    std::string& side = torque > 0 ? names.further : names.back;
    side += (side.empty() ? "" : ", ") + name;
  }
  return names;
}

double TiltingTorque::strongest(const std::vector<motion::Sample>& samples) const {
  double strongest = 0, possible = 0;
  for (const motion::Sample& sample : samples) {
    strongest = std::max(strongest, sides(sample).larger());
  }
  const double rate = tilt_.steady_rate();
  for (const Element& element : elements_) {
    possible += rate * rate * element.second_moment.trace();
  }
  return strongest > rounding * possible ? strongest : 0;
}

}  // namespace twrench::timeline
