#include "cli/random_scene.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

#include "scene_dice.h"

namespace twrench {
namespace {

using Eigen::Vector3d;

/// From 10^-decades to 10^decades.
double scale(SceneDice& dice, double decades) {
  return std::pow(10, dice.uniform(-decades, decades));
}

/// A unit vector near the axis, or any if that is none.
Vector3d direction(SceneDice& dice, int axis) {
  const Vector3d any = dice.vector(-1, 1);
  if (axis < 0) return any.normalized();
  return (Vector3d(Vector3d::Unit(axis)) + dice.uniform(0.001, 0.1) * any).normalized();
}

}  // namespace

RandomScene random_scene(std::uint32_t seed, std::uint32_t number) {
  static constexpr std::array axes{1, 0, 1, 2, -1};
  SceneDice dice(seed, number);
  const double length = scale(dice, 6), mass = scale(dice, 6);
  const double turn = scale(dice, number % 4 == 3 ? 9 : 6);
  // The edges differ by a tenth at least and are in ascending order, so that y is the intermediate
  // axis.
  const double x = dice.uniform(0.1, 0.5), y = x + dice.uniform(0.1, 0.3);
  const Vector3d edges = length * Vector3d(x, y, y + dice.uniform(0.1, 0.3));
  const Vector3d squares = edges.array().square();
  const Vector3d moments = mass / 12 * (Vector3d::Constant(squares.sum()) - squares);
  const Vector3d omega = 2 * std::numbers::pi / turn * direction(dice, axes[number % axes.size()]);
  const double density = mass / edges.prod();
  // Within the limits of scene files for parts; otherwise the moments are given.
  const bool solid = density > 1e-9 && density < 1e6;
  const std::string body =
      solid ? fmt::format("[[part]]\nshape = \"box\"\nsize = [{}, {}, {}]\ndensity = {}\n",
                          edges[0], edges[1], edges[2], density)
            : fmt::format("[body]\nmoments = [{}, {}, {}]\n", moments[0], moments[1], moments[2]);
  return {body + fmt::format("[motion]\nomega = [{}, {}, {}]\n", omega[0], omega[1], omega[2]),
          solid ? "" : fmt::format("--inertia {},{},{}", moments[0], moments[1], moments[2]),
          fmt::format("--omega={},{},{}", omega[0], omega[1], omega[2])};
}

CommandSubject subject_of(const RandomScene& random, bool by_options) {
  CommandSubject subject{scene::parse_scene(random.toml, "own.toml"), "own.toml", "own.toml",
                         "--scene own.toml"};
  if (by_options && !random.inertia.empty()) {
    subject.words = random.inertia + " " + random.omega;
    subject.body = subject.checked_body = random.inertia;
  }
  return subject;
}

}  // namespace twrench
