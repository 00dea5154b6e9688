#include "picture/body/shadow_balls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::picture {

std::vector<Ball> shadow_balls(const Capsule& capsule) {
  // Limits the number of gaps between spheres: the shadow of a wire is invisible anyway.
  constexpr double most_gaps = 60;
  const Eigen::Vector3d along = capsule.to - capsule.from;
  const double apart = std::numbers::pi / 2 * capsule.radius;
  const int gaps = static_cast<int>(std::lround(std::min(along.norm() / apart, most_gaps)));
  std::vector<Ball> balls;
  for (int i = 0; i <= gaps; ++i) {
    const double share = gaps > 0 ? double(i) / gaps : 0.5;
    balls.push_back({capsule.from + share * along, capsule.radius});
  }
  return balls;
}

std::vector<Ball> shadow_balls(std::span<const body::Part> parts) {
  std::vector<Ball> balls;
  for (const body::Part& part : parts) {
    for (const Capsule& capsule : capsules_of(part)) {
      const std::vector<Ball> own = shadow_balls(capsule);
      balls.insert(balls.end(), own.begin(), own.end());
    }
  }
  return balls;
}

}  // namespace twrench::picture
