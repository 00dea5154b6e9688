#include "scene/dimensions.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <Eigen/Geometry>

namespace twrench::scene {
namespace {

struct NameOf {
  std::string operator()(const body::Cylinder&) const { return "cylinder"; }
  std::string operator()(const body::Box&) const { return "box"; }
  std::string operator()(const body::Ellipsoid&) const { return "ellipsoid"; }
  std::string operator()(const body::Cone&) const { return "cone"; }
  std::string operator()(const body::Torus&) const { return "torus"; }
  std::string operator()(const body::Capsule&) const { return "capsule"; }
  std::string operator()(const body::Tube&) const { return "tube"; }
  std::string operator()(const body::Mesh&) const { return "mesh"; }
};

void require_hole(const std::string& what, double inner, double radius) {
  if (inner < radius) return;
  throw OutOfRange(what, fmt::format("is {}, but must be less than the radius, {}", inner, radius),
                   {inner, limits::length.low, radius});
}

/// A file's unit is easily mistaken, and then the mesh is a thousand times too large.
void check_size(const std::string& what, const body::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  const double size = box.diagonal().norm();
  if (!limits::mesh_size.allows(size)) {
    throw OutOfRange(what,
                     fmt::format("the mesh is {:.6g} cm across, but that must be {}", size,
                                 limits::mesh_size.describe()),
                     {size, limits::mesh_size.low, limits::mesh_size.high}, "check its unit");
  }
  limits::check(limits::coordinate, what, box.min());
  limits::check(limits::coordinate, what, box.max());
}

}  // namespace

std::string shape_name(const body::Shape& shape) { return std::visit(NameOf(), shape); }

void check_dimensions(const body::Shape& shape, const PlaceOf& place_of) {
  const auto check = [&](const char* key, const auto& value, const limits::Limit& limit) {
    limits::check(limit, place_of(key), value);
  };
  std::visit([&](const auto& known) { for_dimensions(known, check); }, shape);
  if (const auto* torus = std::get_if<body::Torus>(&shape)) {
    require_hole(place_of("tube_radius"), torus->tube_radius, torus->radius);
  } else if (const auto* tube = std::get_if<body::Tube>(&shape)) {
    require_hole(place_of("inner_radius"), tube->inner_radius, tube->radius);
  } else if (const auto* mesh = std::get_if<body::Mesh>(&shape)) {
    check_size(place_of("file"), *mesh->surface);
  }
}

}  // namespace twrench::scene
