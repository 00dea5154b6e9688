#include "scene/dimensions.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <Eigen/Geometry>

namespace twrench::scene {
namespace {

/// Checks the size of a mesh. With the wrong unit it is often a thousand times too large.
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

const limits::Limit& limit_of(const body::Dimension& dimension) {
  return dimension.may_be_zero ? limits::length_or_none : limits::length;
}

void check_dimensions(body::Shape shape, const PlaceOf& place_of) {
  const std::vector<body::Dimension> dimensions = body::dimensions(shape);
  for (const body::Dimension& dimension : dimensions) {
    for (const double value : dimension.values) {
      limits::check(limit_of(dimension), place_of(dimension.key), value);
    }
  }
  for (const body::Dimension& dimension : dimensions) {
    if (dimension.greater == nullptr || dimension.values[0] < *dimension.greater) continue;
    const double value = dimension.values[0], greater = *dimension.greater;
    throw OutOfRange(place_of(dimension.key),
                     fmt::format("is {}, but must be less than the {}, {}", value,
                                 dimension.greater_key, greater),
                     {value, limits::length.low, greater});
  }
  if (const auto* mesh = std::get_if<body::Mesh>(&shape)) {
    check_size(place_of("file"), *mesh->surface);
  }
}

}  // namespace twrench::scene
