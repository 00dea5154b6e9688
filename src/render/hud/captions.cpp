#include "render/hud/captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace twrench::render::captions {
namespace {

using Eigen::Vector3d;

/// Half the shape's extent along a direction, a unit vector in its own axes.
struct HalfExtent {
  Vector3d along;

  double operator()(const body::Cylinder& c) const {
    return std::abs(along.z()) * c.length / 2 + std::hypot(along.x(), along.y()) * c.radius;
  }
  double operator()(const body::Box& b) const { return along.cwiseAbs().dot(b.size) / 2; }
  double operator()(const body::Ellipsoid& e) const { return along.cwiseProduct(e.radii).norm(); }
  double operator()(const auto& shape) const { return body::bounding_radius(shape); }
};

double half_extent(const body::Part& part, int axis) {
  return std::visit(HalfExtent{part.body_from_part.row(axis).transpose()}, part.shape);
}

/// Positions are from the centre of mass.
bool is_leg(const body::Part& part) {
  constexpr double on_axis = 1e-6;
  const double along = half_extent(part, 0);
  const double across = std::max(half_extent(part, 1), half_extent(part, 2));
  return part.position.x() > 0 && along > across &&
         part.position.tail<2>().norm() < on_axis * along;
}

bool has_leg(const scene::Body& body) {
  const std::vector<body::Part> parts = scene::visible_parts(body);
  const auto reach = [](const body::Part& part) {
    return std::abs(part.position.x()) + half_extent(part, 0);
  };
  const auto farthest = std::ranges::max_element(parts, {}, reach);
  const bool alone = std::ranges::all_of(parts, [&](const body::Part& part) {
    return &part == &*farthest || reach(part) < 0.999 * reach(*farthest);
  });
  return parts.size() > 1 && alone && is_leg(*farthest);
}

}  // namespace

std::string curve(const scene::Body& body) {
  return has_leg(body) ? "which way the leg points" : "the body's x axis along space x";
}

std::string momentum_heading() { return "L, seen from the body"; }
std::string poinsot_heading() { return "the ellipsoid rolls"; }

std::string momentum(const timeline::Solution& solution, const PrincipalFrame& frame) {
  if (frame.direction.isZero(0.0)) return "The body is at rest: it has no angular momentum.";
  const std::string sphere =
      "The angular momentum L, seen from the body. Its length is constant, so its tip stays on a "
      "sphere; ";
  if (!frame.level) return sphere + "as all moments are equal, it stays where it is.";
  const std::string level = sphere + "the energy is constant, so it stays on one curve. ";
  if (solution.flips) {
    return level + fmt::format(
                       "Close to the bold curve this leads from one end of the {} axis to "
                       "the other: the body turns over.",
                       frame.names[1]);
  }
  return level + fmt::format("It stays on one side of the body, about the {} axis.",
                             frame.names[static_cast<std::size_t>(frame.level->axis)]);
}

std::string poinsot(const timeline::Solution& solution) {
  if (solution.body.momentum().isZero(0.0)) {
    return "The body's inertia ellipsoid. The body is at rest.";
  }
  return "The body's inertia ellipsoid rolls without slipping on a plane that never moves, normal "
         "to "
         "L. It touches the plane at ω, the axis about which the body turns at that moment.";
}

Remarks::Remarks(const timeline::Solution& solution)
    : flips_(solution.flips),
      flip_times_(solution.flip_times),
      axis_(solution.body.principal().axes.col(1)),
      momentum_(solution.body.momentum()) {}

/// Returns 1 where L has left the intermediate axis, from one end of which to the other it swings,
/// and less where it comes close to its turning points.
double Remarks::share_of_flip(const motion::Sample& sample) const {
  constexpr double begins = 0.95, full = 0.85;  // of L's largest component along that axis
  const Vector3d direction = (sample.X.transpose() * momentum_).stableNormalized();
  const double along = std::abs(axis_.dot(direction)) / std::sin(flips_->swing / 2);
  return std::clamp((begins - along) / (begins - full), 0.0, 1.0);
}

Remark Remarks::at(const timeline::SolutionState& state) const {
  constexpr double visible = 0.01;
  if (state.diagnostics.orthogonality_error > visible) return {no_rotation};
  const bool flips = std::ranges::any_of(flip_times_, [&](double flip) {
    return std::abs(state.sample.t - flip) < flips_->interval / 2;
  });
  const double share = flips ? share_of_flip(state.sample) : 0;
  return share > 0 ? Remark{turns_over, share} : Remark{};
}

}  // namespace twrench::render::captions
