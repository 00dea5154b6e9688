#include "picture/overlay/force_arrows.h"

#include <algorithm>

#include "picture/look/emphasis.h"
#include "scene/reference_frame.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

// As multiples of the body's radius.
constexpr double longest_force = 0.5, shortest_force = 0.02, force_shaft = 0.013, small_part = 0.3,
                 off_the_end = 0.02;
constexpr double long_axis = 0.5;  // of a part, in units of its longest

/// Returns the points of a part whose forces are shown.
std::vector<ForceArrows::Point> shown_points(const body::Part& part, double radius) {
  const auto all = body::equimomental_points(part);
  const Vector3d middle = body::centroid(part.shape);
  const Vector3d centre = part.position + part.body_from_part * middle;
  const auto arm = [&](const body::PointMass& point) { return (point.position - centre).norm(); };
  double longest = 0;
  for (const body::PointMass& point : all) longest = std::max(longest, arm(point));
  if (longest < small_part * radius) {
    return {{{6 * all[0].mass, centre}, centre, body::bounding_radius(part.shape, middle)}};
  }
  std::vector<ForceArrows::Point> points;
  for (const body::PointMass& point : all) {
    if (arm(point) < long_axis * longest) continue;
    const Vector3d out = (point.position - centre).normalized();
    points.push_back({point, point.position + off_the_end * radius * out, 0});
  }
  return points;
}

const Vector3d& force_of(const motion::PointForces& forces, Force kind) {
  if (kind == Force::centrifugal) return forces.centrifugal;
  if (kind == Force::coriolis) return forces.coriolis;
  return kind == Force::euler ? forces.euler : forces.constraint;
}

}  // namespace

ForceArrows::ForceArrows(const scene::Scene& scene, const timeline::Solution& solution,
                         double radius)
    : colors_(style_of(scene.look.theme).overlay),
      is_dimmed_(is_dimmed(scene.overlay, scene::Feature::forces)),
      shaft_(force_shaft * thickness_of(scene.overlay, scene::Feature::forces)),
      frame_(scene.camera.frame),
      forces_(shown_forces(scene.overlay, forces_in(frame_))),
      body_(solution.body),
      radius_(radius) {
  for (const body::Part& part : scene::massive_parts(scene.body)) {
    std::ranges::copy(shown_points(part, radius), std::back_inserter(points_));
  }
  constexpr std::size_t stride = 8;  // of the samples, which are finer than needed here
  const auto for_each_force = [&](const auto& visit_one) {
    for (std::size_t i = 0; i < solution.whole.size(); i += stride) {
      const motion::Sample& sample = solution.whole[i];
      const motion::RotatingFrame frame = scene::reference_frame(frame_, body_, sample);
      visit(frame, sample, [&](const Vector3d& start, const Vector3d& force, Force) {
        visit_one(frame, start, force);
      });
    }
  };
  double strongest = 0;
  for_each_force([&](const motion::RotatingFrame&, const Vector3d&, const Vector3d& force) {
    strongest = std::max(strongest, force.norm());
  });
  if (!(strongest > 0)) return;
  scale_ = longest_force * radius / strongest;
  for_each_force(
      [&](const motion::RotatingFrame& frame, const Vector3d& start, const Vector3d& force) {
        extent_.emplace_back(frame.attitude.transpose() * (start + scale_ * force));
      });
}

/// Calls `visit` with the start of the arrow and the force in space, and its kind, for each arrow.
template <typename Visit>
void ForceArrows::visit(const motion::RotatingFrame& frame, const motion::Sample& sample,
                        Visit visit) const {
  const motion::FrameForces forces(frame, body_, sample);
  for (const auto& [point, start, clearance] : points_) {
    const motion::PointForces on = forces.on(point.mass, point.position);
    for (const Force kind : forces_) {
      const Vector3d force = frame.attitude * force_of(on, kind);
      visit(sample.X * start + clearance * force.stableNormalized(), force, kind);
    }
  }
}

void ForceArrows::draw(const timeline::SolutionState& instant, DrawList& opaque) const {
  const motion::RotatingFrame frame = scene::reference_frame(frame_, body_, instant.sample);
  visit(frame, instant.sample, [&](const Vector3d& start, const Vector3d& force, Force kind) {
    const Vector3d arrow = scale_ * force;
    if (arrow.norm() < shortest_force * radius_) return;
    const Color color = color_of(kind, colors_);
    opaque.arrow(start, start + arrow, shaft_ * radius_,
                 {is_dimmed_ ? dimmed(color, colors_) : color});
  });
}

}  // namespace twrench::picture
