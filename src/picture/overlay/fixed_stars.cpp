#include "picture/overlay/fixed_stars.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "picture/look/sky.h"
#include "picture/look/theme.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int star_count = 260;
constexpr double star_distance = 12;     // in units of the camera's distance from the body
constexpr double star_width = 3.4;       // px of the brightest, in a picture of 1080
constexpr double brightest_star = 0.75;  // opacity
constexpr double fading_streak = 12;  // widths; a streak of this length is half as bright as a dot
constexpr double fading_trail = 60;   // the same for a trail, which becomes fainter less quickly

/// Returns the cosine of the angle from the middle of the view to the farthest corner of its
/// picture, with a margin.
double cosine_of_corner(const Camera& camera) {
  const Eigen::Matrix4d& p = camera.projection;
  const double x = (1 + std::abs(p(0, 2))) / p(0, 0), y = (1 + std::abs(p(1, 2))) / p(1, 1);
  return std::cos(std::min(1.1 * std::atan(std::hypot(x, y)), std::numbers::pi));
}

int rounded(double share) { return static_cast<int>(std::lround(255 * share)); }

}  // namespace

FixedStars::FixedStars(const scene::Scene& scene, int height) {
  const ThemeStyle& style = style_of(scene.look.theme);
  if (are_of_theme(scene)) {
    add_sky(style.backdrop.stars, height);
  } else {
    add_spiral(style.overlay.dim, height);
  }
}

bool FixedStars::are_of_theme(const scene::Scene& scene) {
  return style_of(scene.look.theme).backdrop.stars > 0 && !scene.look.background &&
         !scene.look.transparent;
}

void FixedStars::add_sky(int count, int height) {
  for (const Star& star : sky(count)) {
    dots_.push_back({star.direction,
                     2 * star.radius(height),
                     {{255, rounded(star.tint), 255}, star.light(height)}});
  }
}

/// The stars are spread evenly, each on a turn of a spiral from pole to pole.
void FixedStars::add_spiral(const Color& color, int height) {
  std::mt19937 random;  // always the same sky
  const auto noise = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < star_count; ++i) {
    const double up = 1 - 2 * (i + noise()) / star_count;
    const double angle = 2 * std::numbers::pi * (i * std::numbers::phi + 0.1 * noise());
    const double across = std::sqrt(std::max(0.0, 1 - up * up));
    const double brightness = 0.2 + 0.8 * std::pow(noise(), 3);
    dots_.push_back({{across * std::cos(angle), up, across * std::sin(angle)},
                     star_width * std::sqrt(brightness) * height / 1080,
                     {color, brightest_star * brightness}});
  }
}

void FixedStars::draw(const Camera& camera, const Turning& turning, DrawList& translucent) const {
  const double distance = star_distance * camera.distance, corner = cosine_of_corner(camera);
  const Vector3d ahead = -camera.camera_from_space().row(2).transpose();
  std::vector<Vector3d> views;  // the directions of the view at each time, as of now
  for (const Matrix3d& rotation : turning.rotations) views.push_back(rotation.transpose() * ahead);
  const auto last = static_cast<double>(turning.rotations.size() - 1);
  std::vector<DrawList::Point> streak;
  for (const auto& [direction, width, ink] : dots_) {
    const auto is_seen = [&, &star = direction](const Vector3d& view) {
      return view.dot(star) > corner;
    };
    if (std::ranges::none_of(views, is_seen)) continue;
    streak.clear();
    double length = 0;
    for (const Matrix3d& rotation : turning.rotations) {
      const Vector3d place = distance * (rotation * direction);
      if (!streak.empty()) {
        length += (place - streak.back().place).norm() * translucent.pixels(place);
      }
      streak.push_back({place, width, ink});
    }
    if (length <= 1) {
      translucent.dot(distance * direction, width / 2, ink);
      continue;
    }
    const double share = turning.fades ? 1 / std::sqrt(1 + length / (fading_trail * width))
                                       : 1 / (1 + length / (fading_streak * width));
    for (std::size_t i = 0; i < streak.size(); ++i) {
      streak[i].ink.opacity *= turning.fades ? share * static_cast<double>(i) / last : share;
    }
    translucent.line(streak);
  }
}

}  // namespace twrench::picture
