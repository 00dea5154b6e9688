#include "picture/views/principal_frame.h"

#include <algorithm>

#include "scene/prediction.h"

namespace twrench::picture {

PrincipalFrame::PrincipalFrame(const motion::FreeBody& body, const OverlayColors& palette)
    : axes(body.principal().axes) {
  constexpr double along = 1 - 1e-9;
  const bool own = axes.cwiseAbs().colwise().maxCoeff().minCoeff() > along;
  for (std::size_t i = 0; i < 3; ++i) {
    auto axis = axes.col(static_cast<Eigen::Index>(i));
    Eigen::Index nearest = 0;
    axis.cwiseAbs().maxCoeff(&nearest);
    if (axis[nearest] < 0) axis = -axis;
    colors[i] = palette.axis[own ? static_cast<std::size_t>(nearest) : i];
    names[i] = scene::axis_name(axes, static_cast<int>(i));
  }
  direction = axes.transpose() * body.momentum().stableNormalized();
  if (!direction.isZero(0.0)) level = motion::level_through(body.principal().moments, direction);
}

double shown(const Eigen::Vector3d& place, const Eigen::Vector3d& outward,
             const Eigen::Vector3d& eye) {
  constexpr double through = 0.22, ramp = 0.12;
  const double facing = outward.normalized().dot((eye - place).normalized());
  const double t = std::clamp(0.5 + facing / ramp, 0.0, 1.0);
  return through + (1 - through) * t * t * (3 - 2 * t);
}

}  // namespace twrench::picture
