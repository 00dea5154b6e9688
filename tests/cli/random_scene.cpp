#include "cli/random_scene.h"

#include <fmt/format.h>
#include <twrench/math/so3.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

#include "scene_dice.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// From 10^-decades to 10^decades.
double scale(SceneDice& dice, double decades) {
  return std::pow(10, dice.uniform(-decades, decades));
}

/// A unit vector near the axis, or any unit vector if `axis` is not an axis.
Vector3d direction(SceneDice& dice, int axis) {
  const Vector3d any = dice.vector(-1, 1);
  if (axis < 0) return any.normalized();
  return (Vector3d(Vector3d::Unit(axis)) + dice.uniform(0.001, 0.1) * any).normalized();
}

/// A body without parts, as text of a scene file and as an option.
struct InertiaTexts {
  std::string toml, option;
};

InertiaTexts texts_of(const Matrix3d& I) {
  const double x = I(0, 0), y = I(1, 1), z = I(2, 2), xy = I(0, 1), xz = I(0, 2), yz = I(1, 2);
  if (I.isDiagonal(0)) {
    return {fmt::format("[body]\nmoments = [{}, {}, {}]\n", x, y, z),
            fmt::format("--inertia {},{},{}", x, y, z)};
  }
  return {fmt::format("[body]\ninertia = [[{}, {}, {}], [{}, {}, {}], [{}, {}, {}]]\n", x, xy, xz,
                      xy, y, yz, xz, yz, z),
          fmt::format("--inertia {},{},{},{},{},{}", x, y, z, xy, xz, yz)};
}

/// The inertia in other axes, exactly symmetric.
Matrix3d turned(const Matrix3d& inertia, const Matrix3d& R) {
  const Matrix3d product = R * inertia * R.transpose();
  return (product + product.transpose()) / 2;
}

}  // namespace

RandomScene random_scene(std::uint32_t seed, std::uint32_t number) {
  static constexpr std::array axes{1, 0, 1, 2, -1};
  SceneDice dice(seed, number);
  const double length = scale(dice, 6), mass = scale(dice, 6);
  const double turn = scale(dice, number % 4 == 3 ? 9 : 6);
  // The edges ascend and differ by at least a tenth, so that y is the intermediate axis.
  const double x = dice.uniform(0.1, 0.5), y = x + dice.uniform(0.1, 0.3);
  const Vector3d edges = length * Vector3d(x, y, y + dice.uniform(0.1, 0.3));
  const Vector3d squares = edges.array().square();
  const Vector3d moments = mass / 12 * (Vector3d::Constant(squares.sum()) - squares);
  const Vector3d own_omega =
      2 * std::numbers::pi / turn * direction(dice, axes[number % axes.size()]);
  const double density = mass / edges.prod();
  // Parts if the density is within the limits of scene files, otherwise inertias; every other
  // inertia is about axes that are not principal.
  const bool solid = density > 1e-9 && density < 1e6;
  const bool is_turned = !solid && number % 4 >= 2;
  const Matrix3d R = is_turned ? so3::exp(dice.vector(-2, 2)) : Matrix3d::Identity();
  const Vector3d omega = R * own_omega;
  const InertiaTexts inertia = texts_of(turned(moments.asDiagonal(), R));
  const std::string body =
      solid ? fmt::format("[[part]]\nshape = \"box\"\nsize = [{}, {}, {}]\ndensity = {}\n",
                          edges[0], edges[1], edges[2], density)
            : inertia.toml;
  return {body + fmt::format("[motion]\nomega = [{}, {}, {}]\n", omega[0], omega[1], omega[2]),
          solid ? "" : inertia.option,
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
