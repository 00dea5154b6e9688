#include "picture/look/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "picture/space/camera.h"
#include "scene/scene.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

/// Adds stars with a generator whose fixed seed always gives the same sky.
class Sky {
 public:
  Sky() {
    const scene::CameraPath path;
    home_ = frame_sphere(
        {direction_of(path.azimuth, path.elevation), path.field_of_view, 16.0 / 9.0, 1});
  }

  const Camera& home() const { return home_; }
  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }

  /// Adds a star at a place in the picture of the home camera, -1 to 1 across and up.
  void add_at(double x, double y) {
    const Eigen::Matrix4d& p = home_.projection;
    add(home_.camera_from_space().transpose() * Vector3d(x / p(0, 0), y / p(1, 1), -1));
  }

  /// Adds a star in a direction, unless it is in that picture.
  void add_beside(const Vector3d& direction) {
    const Eigen::Matrix4d& p = home_.projection;
    const Vector3d seen = home_.camera_from_space() * direction;
    add(direction);
    const bool is_in_picture = seen.z() < 0 && std::abs(p(0, 0) * seen.x()) < -seen.z() &&
                               std::abs(p(1, 1) * seen.y()) < -seen.z();
    if (is_in_picture) stars.pop_back();
  }

  std::vector<Star> stars;

 private:
  void add(const Vector3d& direction) {
    const double brightness = std::pow(uniform(), 5);  // few are bright
    stars.push_back({direction.normalized(), brightness, 0.94 + 0.06 * uniform()});
  }

  Camera home_;
  std::mt19937 random_{1};
};

double true_radius(const Star& star, int height) {
  return height / 1080.0 * (0.75 + 0.6 * star.brightness);
}

}  // namespace

double Star::radius(int height) const { return std::max(0.8, true_radius(*this, height)); }

double Star::light(int height) const {
  return (40 + 190 * brightness) / 255 * true_radius(*this, height) / radius(height);
}

std::vector<Star> sky(int count) {
  Sky sky;
  for (int i = 0; i < count; ++i) {
    const double x = 2 * sky.uniform() - 1;
    sky.add_at(x, 1 - 2 * sky.uniform());
  }
  // The same number per solid angle as in the picture.
  const Eigen::Matrix4d& p = sky.home().projection;
  const int all = static_cast<int>(std::round(count * std::numbers::pi * p(0, 0) * p(1, 1)));
  for (int i = 0; i < all; ++i) {
    const double height = 1 - 2 * (i + sky.uniform()) / all;
    const double across = std::sqrt(std::max(0.0, 1 - height * height));
    const double angle = 2 * std::numbers::pi * sky.uniform();
    sky.add_beside({across * std::cos(angle), height, across * std::sin(angle)});
  }
  return std::move(sky.stars);
}

}  // namespace twrench::picture
