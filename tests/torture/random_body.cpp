#include "random_body.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "body/dimensions.h"
#include "mesh/mesh_file.h"

namespace twrench::torture {
namespace {

using Eigen::Vector3d;

/// A closed surface around the origin, with dents that never reach it.
body::TriangleMesh random_surface(SceneDice& dice, const Vector3d& radii) {
  body::TriangleMesh mesh;
  const int rings = dice.whole(2, 12), sides = dice.whole(3, 24);
  const double dents = dice.chance(0.3) ? 0 : dice.uniform(0, 0.5);
  const auto add = [&](const Vector3d& direction) {
    mesh.vertices.emplace_back((1 - dice.uniform(0, 1) * dents) * direction.cwiseProduct(radii));
  };
  for (int ring = 1; ring < rings; ++ring) {
    const double across = std::numbers::pi * ring / rings;
    for (int side = 0; side < sides; ++side) {
      const double around = 2 * std::numbers::pi * side / sides;
      add({std::sin(across) * std::cos(around), std::sin(across) * std::sin(around),
           std::cos(across)});
    }
  }
  add(Vector3d::UnitZ());
  add(-Vector3d::UnitZ());
  const auto at = [&](int ring,
                      int side) {  // ring 0 is above the first, and `rings` below the last
    if (ring == 0) return static_cast<std::uint32_t>((rings - 1) * sides);
    if (ring == rings) return static_cast<std::uint32_t>((rings - 1) * sides + 1);
    return static_cast<std::uint32_t>((ring - 1) * sides + side % sides);
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int side = 0; side < sides; ++side) {
      const auto a = at(ring, side), b = at(ring, side + 1), c = at(ring + 1, side),
                 d = at(ring + 1, side + 1);
      if (ring > 0) mesh.triangles.push_back({a, c, b});
      if (ring + 1 < rings) mesh.triangles.push_back({b, c, d});
    }
  }
  if (dice.chance(0.3)) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const auto channel = [&] { return static_cast<float>(dice.uniform(0, 1)); };
      mesh.colors.push_back({channel(), channel(), channel()});
    }
  }
  return mesh;
}

/// Adds a typical flaw of real meshes.
void damage(SceneDice& dice, body::TriangleMesh& mesh) {
  const auto triangle =
      static_cast<std::size_t>(dice.whole(0, static_cast<int>(mesh.triangles.size()) - 1));
  const auto vertex =
      static_cast<std::uint32_t>(dice.whole(0, static_cast<int>(mesh.vertices.size()) - 1));
  switch (dice.whole(0, 6)) {
    case 0:
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
      break;
    case 1:
      std::swap(mesh.triangles[triangle][0], mesh.triangles[triangle][1]);
      break;
    case 2:
      for (auto& corners : mesh.triangles) std::swap(corners[0], corners[1]);
      break;
    case 3:
      mesh.triangles[triangle][0] = vertex;
      break;
    case 4:
      mesh.vertices[vertex] *= dice.pick(std::array{0.0, -3.0, 1e-300, 1e300, std::nan("")});
      break;
    case 5:
      mesh.triangles[triangle][1] = static_cast<std::uint32_t>(mesh.vertices.size());
      break;
    default:  // a duplicate of a vertex in almost the same place
      mesh.vertices.emplace_back(mesh.vertices[vertex] * (1 + dice.spread(1e-16, 1e-3)));
      if (!mesh.colors.empty()) mesh.colors.push_back(mesh.colors[vertex]);
      mesh.triangles[triangle][2] = static_cast<std::uint32_t>(mesh.vertices.size()) - 1;
  }
}

body::Shape random_mesh(SceneDice& dice, const Vector3d& radii) {
  body::TriangleMesh mesh = random_surface(dice, radii);
  const Vector3d away = dice.chance(0.2) ? dice.vector(-1e4, 1e4) : Vector3d::Zero();
  for (Vector3d& vertex : mesh.vertices) vertex += away.cwiseProduct(radii);
  if (dice.chance(0.3)) damage(dice, mesh);
  mesh::ReadOptions options;
  if (dice.chance(0.3)) options.weld = radii.minCoeff() * dice.spread(1e-12, 0.1);
  if (dice.chance(0.3)) options.shell = radii.minCoeff() * dice.spread(1e-3, 0.1);
  return mesh::checked_mesh("mesh", std::move(mesh), options).shape;
}

body::Shape random_shape(SceneDice& dice, double size) {
  const double least = dice.chance(0.1) ? 1e-4 : 0.02;  // wires, needles and sheets too
  const auto length = [&] { return size * dice.spread(least, 2); };
  const std::vector<body::Shape> shapes = body::all_shapes();
  body::Shape shape = dice.pick(shapes);
  if (std::holds_alternative<body::Mesh>(shape)) {
    const double x = length(), y = length();
    return random_mesh(dice, Vector3d(x, y, length()));
  }
  for (const body::Dimension& dimension : body::dimensions(shape)) {
    const bool are_equal = dice.chance(0.3);
    for (double& value : dimension.values) value = length();
    if (are_equal) std::ranges::fill(dimension.values, dimension.values[0]);
    if (dimension.may_be_zero && dice.chance(0.5)) dimension.values[0] = 0;
    if (dimension.greater) dimension.values[0] = *dimension.greater * dice.uniform(0.01, 0.99);
  }
  return shape;
}

body::Part random_part(SceneDice& dice, double size) {
  const body::Shape shape = random_shape(dice, size);
  const double density = dice.spread(0.1, 20);
  const Vector3d position = size * dice.vector(-1.5, 1.5);
  const Vector3d turn = dice.chance(0.3)
                            ? Vector3d(std::numbers::pi / 2 * Vector3d::Unit(dice.whole(0, 2)))
                            : dice.vector(-3, 3);
  return {shape, density, position, so3::exp(turn)};
}

scene::PartDescription random_description(SceneDice& dice) {
  scene::PartDescription description;
  if (dice.chance(0.3)) description.name = dice.pick(std::array{"a", "b"});
  vary(dice, description.look);
  if (dice.chance(0.5)) description.look.crease_angle = dice.uniform(0, std::numbers::pi);
  return description;
}

}  // namespace

scene::Body random_body(SceneDice& dice) {
  scene::Body body;
  if (dice.chance(0.15)) {
    const double x = dice.spread(0.01, 1), y = dice.spread(0.01, 1), z = dice.spread(0.01, 1);
    const Vector3d moments = dice.spread(1e-3, 1e6) * Vector3d(y + z, z + x, x + y);
    const Eigen::Matrix3d axes =
        dice.chance(0.5) ? Eigen::Matrix3d::Identity() : so3::exp(dice.vector(-3, 3));
    const Eigen::Matrix3d inertia = axes * moments.asDiagonal() * axes.transpose();
    body.inertia = (inertia + inertia.transpose()) / 2;  // exactly symmetric
    body.drawn_as = dice.pick(std::array{scene::Equimomental::box, scene::Equimomental::ellipsoid,
                                         scene::Equimomental::cross});
    return body;
  }
  const double size = dice.chance(0.1) ? dice.spread(1e-6, 1e5) : dice.spread(1e-2, 1e3);
  const int count = dice.whole(1, 8);
  for (int i = 0; i < count; ++i) {
    body.parts.push_back(random_part(dice, size));
    body.descriptions.push_back(random_description(dice));
  }
  return body;
}

}  // namespace twrench::torture
