#include "page/shadow_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/body/occluders.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;

constexpr double most_gaps = 60;        // between the balls of a part, as in the film
constexpr std::size_t most_balls = 64;  // as in web/picture/ground.frag

std::vector<Ball> all_balls(std::span<const body::Part> parts) {
  std::vector<Ball> balls;
  for (const body::Part& part : parts) {
    for (const render::Capsule& capsule : render::capsules_of(part)) {
      const Vector3d along = capsule.to - capsule.from;
      const double apart = std::numbers::pi / 2 * capsule.radius;
      const int gaps = static_cast<int>(std::lround(std::min(along.norm() / apart, most_gaps)));
      for (int i = 0; i <= gaps; ++i) {
        const double share = gaps > 0 ? double(i) / gaps : 0.5;
        balls.push_back({capsule.from + share * along, capsule.radius});
      }
    }
  }
  return balls;
}

/// A ball of the same section as both, in the middle of them.
Ball together(const Ball& a, const Ball& b) {
  const double of_a = a.radius * a.radius, of_b = b.radius * b.radius;
  return {(of_a * a.centre + of_b * b.centre) / (of_a + of_b), std::sqrt(of_a + of_b)};
}

/// How much the shadow is changed by taking two together: the second moment of their sections.
double cost(const Ball& a, const Ball& b) {
  const double of_a = a.radius * a.radius, of_b = b.radius * b.radius;
  return of_a * of_b / (of_a + of_b) * (a.centre - b.centre).squaredNorm();
}

/// Takes together the two that cost least.
void take_two_together(std::vector<Ball>& balls) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t first = 0, second = 1;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t k = i + 1; k < balls.size(); ++k) {
      const double found = cost(balls[i], balls[k]);
      if (found < least) least = found, first = i, second = k;
    }
  }
  balls[first] = together(balls[first], balls[second]);
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(second));
}

}  // namespace

std::vector<Ball> shadow_balls(std::span<const body::Part> parts) {
  std::vector<Ball> balls = all_balls(parts);
  while (balls.size() > most_balls) take_two_together(balls);
  return balls;
}

}  // namespace twrench::page
