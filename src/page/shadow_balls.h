#pragma once

#include <twrench/body/shape.h>

#include <span>
#include <vector>

namespace twrench::page {

/// A ball that casts shadow.
struct Ball {
  Eigen::Vector3d centre;  ///< Body axes, cm.
  double radius;           ///< cm
};

/// Returns balls that cast as much shadow as the parts; see render/body/floor.cpp. As many as a
/// shader has room for: of more, those that are closest to one another are taken together.
std::vector<Ball> shadow_balls(std::span<const body::Part> parts);

}  // namespace twrench::page
