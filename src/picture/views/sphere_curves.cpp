#include "picture/views/sphere_curves.h"

#include <twrench/motion/exact.h>
#include <twrench/motion/polhode.h>

#include <cmath>
#include <numbers>

#include "motion/energy_contours.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;
using Curve = SphereCurves::Curve;

/// Returns the points of a closed curve that are given by an angle.
template <typename Point>
Curve closed_curve(const Point& point) {
  constexpr int points = 240;
  Curve curve;
  for (int i = 0; i <= points; ++i) curve.push_back(point(2 * std::numbers::pi * i / points));
  return curve;
}

Curve level_curve(const motion::EnergyLevel& level) {
  return closed_curve([&](double phi) { return level.at(phi); });
}

SphereCurves curves_of_rigid_body(const motion::FreeBody& body, const PrincipalFrame& frame) {
  constexpr int levels = 4;  // around each end of an axis
  SphereCurves curves;
  const Vector3d& moments = body.principal().moments;
  for (const motion::EnergyLevel& level : motion::level_family(moments, levels)) {
    curves.levels.push_back({level_curve(level), static_cast<std::size_t>(level.axis)});
  }
  if (frame.level) curves.path = level_curve(*frame.level);
  if (const auto circles = motion::separatrix(moments)) {
    for (const Vector3d& side : *circles) {
      curves.separatrices.push_back(closed_curve([&](double phi) -> Vector3d {
        return std::cos(phi) * Vector3d::UnitY() + std::sin(phi) * side;
      }));
    }
  }
  return curves;
}

SphereCurves curves_with_interior(const motion::FreeBody& body, const PrincipalFrame& frame) {
  constexpr double spacing = 0.27;  // rad
  if (frame.direction.isZero(0.0)) return {};
  const motion::EnergyContours contours(body);
  // The frame's axes are the principal axes, some of them reversed.
  const Vector3d signs = (frame.axes.transpose() * body.principal().axes).diagonal().array().sign();
  const auto reversed = [&](Curve curve) {
    for (Vector3d& point : curve) point = signs.cwiseProduct(point);
    return curve;
  };
  SphereCurves curves;
  for (const auto& [curve, extremum] : contours.family(spacing)) {
    Eigen::Index axis = 0;
    extremum.mu.cwiseAbs().maxCoeff(&axis);
    curves.levels.push_back({reversed(curve), static_cast<std::size_t>(axis)});
  }
  // With energy loss the momentum crosses the curves.
  if (body.energy_loss() == 0) {
    curves.path = reversed(contours.through(body.principal().axes.transpose() *
                                            body.body_momentum().stableNormalized()));
    if (curves.path.size() == 1) curves.path.clear();
  }
  for (const Curve& curve : contours.separatrices()) curves.separatrices.push_back(reversed(curve));
  for (const auto& equilibrium : contours.equilibria()) {
    curves.equilibria.push_back(signs.cwiseProduct(equilibrium.mu));
  }
  return curves;
}

}  // namespace

SphereCurves sphere_curves(const motion::FreeBody& body, const PrincipalFrame& frame) {
  return body.is_rigid() ? curves_of_rigid_body(body, frame) : curves_with_interior(body, frame);
}

std::optional<Cap> phase_cap(const motion::FreeBody& body, const PrincipalFrame& frame) {
  if (!body.is_rigid() || !frame.level) return std::nullopt;
  if (!motion::ExactMotion(body).phase()) return std::nullopt;
  const motion::EnergyLevel& level = *frame.level;
  return Cap{level.side * Vector3d::Unit(level.axis), level_curve(level)};
}

}  // namespace twrench::picture
