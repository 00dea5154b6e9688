#include "stars.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace twrench::page {
namespace {

using Eigen::Vector3d;

/// Adds stars with the random numbers of the film's stars.
class Sky {
 public:
  explicit Sky(const picture::Camera& home) : home_(home) {}

  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }

  /// Adds a star at a place in the picture, -1 to 1 across and up.
  void add_at(double x, double y) {
    const Eigen::Matrix4d& p = home_.projection;
    const Vector3d in_camera((x + p(0, 2)) / p(0, 0), (y + p(1, 2)) / p(1, 1), -1);
    const auto [brightness, tint] = look();
    add((home_.camera_from_space().transpose() * in_camera).normalized(), brightness, tint);
  }

  /// Adds a star in a direction, unless it is in the picture.
  void add_beside(const Vector3d& direction) {
    const auto [brightness, tint] = look();
    const Eigen::Matrix4d& p = home_.projection;
    const Vector3d seen = home_.camera_from_space() * direction;
    const bool is_in_picture = seen.z() < 0 &&
                               std::abs(p(0, 0) * seen.x() / -seen.z() - p(0, 2)) < 1 &&
                               std::abs(p(1, 1) * seen.y() / -seen.z() - p(1, 2)) < 1;
    if (!is_in_picture) add(direction, brightness, tint);
  }

  std::vector<float> stars;

 private:
  std::pair<double, double> look() {
    const double brightness = std::pow(uniform(), 5);
    return {brightness, 0.94 + 0.06 * uniform()};
  }

  void add(const Vector3d& direction, double brightness, double tint) {
    for (const double x : direction) stars.push_back(static_cast<float>(x));
    stars.push_back(static_cast<float>(brightness));
    stars.push_back(static_cast<float>(tint));
  }

  picture::Camera home_;
  std::mt19937 random_{1};
};

}  // namespace

std::vector<float> stars_around(const picture::Camera& home, int count) {
  Sky sky(home);
  for (int i = 0; i < count; ++i) {
    const double x = 2 * sky.uniform() - 1;
    sky.add_at(x, 1 - 2 * sky.uniform());
  }
  // The same number per solid angle as in the picture.
  const double solid_angles = std::numbers::pi * home.projection(0, 0) * home.projection(1, 1);
  const int all = static_cast<int>(std::min(std::round(count * solid_angles), 6000.0));
  for (int i = 0; i < all; ++i) {
    const double height = 1 - 2 * (i + sky.uniform()) / all;
    const double across = std::sqrt(std::max(0.0, 1 - height * height));
    const double angle = 2 * std::numbers::pi * sky.uniform();
    sky.add_beside({across * std::cos(angle), height, across * std::sin(angle)});
  }
  return std::move(sky.stars);
}

}  // namespace twrench::page
