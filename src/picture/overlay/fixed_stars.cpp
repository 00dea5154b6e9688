#include "picture/overlay/fixed_stars.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "picture/look/theme.h"

namespace twrench::picture {
namespace {

constexpr int star_count = 260;
constexpr double star_distance = 12;     // in units of the camera's distance from the body
constexpr double star_width = 3.4;       // px of the brightest, in a picture of 1080
constexpr double brightest_star = 0.75;  // opacity
constexpr double fading_streak = 12;  // widths; a streak of this length is half as bright as a dot
constexpr int streak_points = 5;

}  // namespace

/// The stars are spread evenly, each on a turn of a spiral from pole to pole.
FixedStars::FixedStars(const scene::Scene& scene)
    : color_(style_of(scene.look.theme).overlay.dim),
      half_open_(0.25 * scene.film.speed / scene.film.fps) {
  std::mt19937 random;  // always the same sky
  const auto noise = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < star_count; ++i) {
    const double height = 1 - 2 * (i + noise()) / star_count;
    const double angle = 2 * std::numbers::pi * (i * std::numbers::phi + 0.1 * noise());
    const double across = std::sqrt(std::max(0.0, 1 - height * height));
    stars_.push_back({{across * std::cos(angle), height, across * std::sin(angle)},
                      0.2 + 0.8 * std::pow(noise(), 3)});
  }
}

void FixedStars::draw(const motion::RotatingFrame& frame, const Camera& camera, int height,
                      DrawList& translucent) const {
  const Eigen::Vector3d omega = frame.attitude * frame.omega;
  std::array<Eigen::Matrix3d, streak_points> turns;
  for (int i = 0; i < streak_points; ++i) {
    const double time = half_open_ * (2.0 * i / (streak_points - 1) - 1);
    turns[static_cast<std::size_t>(i)] = star_distance * camera.distance * so3::exp(-time * omega);
  }
  for (const auto& [direction, brightness] : stars_) {
    std::array<DrawList::Point, streak_points> streak;
    const double width = star_width * std::sqrt(brightness) * height / 1080;
    const double length = 2 * half_open_ * omega.cross(direction).norm() *
                          translucent.pixels(turns[0] * direction) * star_distance *
                          camera.distance;
    const double opacity = brightest_star * brightness / (1 + length / (fading_streak * width));
    for (std::size_t i = 0; i < streak.size(); ++i) {
      streak[i] = {turns[i] * direction, width, {color_, opacity}};
    }
    if (length > 1) {
      translucent.line(streak);
    } else {
      translucent.dot(streak[0].place, width / 2, {color_, opacity});
    }
  }
}

}  // namespace twrench::picture
