#include "page/surface.h"

#include <algorithm>

#include "picture/body/bounding_radius.h"
#include "picture/body/gap_closing.h"
#include "picture/body/hollows.h"

namespace twrench::page {
namespace {

constexpr std::size_t most_vertices = 5000;     // for bodies of few parts; limits the page
constexpr std::size_t most_triangles = 20'000;  // for meshes; likewise
constexpr double finest = 2.3e-4;               // tolerance in radii: invisible in 1440 rows
constexpr double coarsest = 2e-3;

/// Whether a part is a mesh that is simplified anyway and takes seconds to build again with another
/// tolerance.
bool is_large_mesh(const body::Part& part) {
  const auto* const mesh = std::get_if<body::Mesh>(&part.shape);
  return mesh != nullptr && mesh->surface->triangles.size() > most_triangles;
}

picture::Mesh fine_mesh(std::span<const body::Part> parts, std::span<const scene::PartLook> looks,
                        double radius) {
  double tolerance = finest * radius;
  picture::Mesh mesh = picture::body_mesh(parts, tolerance, looks);
  if (std::ranges::any_of(parts, is_large_mesh)) return mesh;
  while (mesh.vertices.size() > most_vertices && tolerance < coarsest * radius) {
    tolerance *= 1.5;
    mesh = picture::body_mesh(parts, tolerance, looks);
  }
  return mesh;
}

}  // namespace

Surface surface_of(const scene::Body& body) {
  const std::vector<body::Part> visible = scene::visible_parts(body);
  Surface surface{.parts = picture::close_gaps(visible),
                  .radius = picture::bounding_radius(visible),
                  .mesh = {},
                  .simplification = {}};
  std::vector<scene::PartLook> looks;
  for (std::size_t i = 0; i < surface.parts.size(); ++i) {
    looks.push_back(scene::description(body, i).look);
  }
  surface.mesh = fine_mesh(surface.parts, looks, surface.radius);
  surface.simplification = simplify(surface.mesh, surface.parts, most_triangles);
  picture::shade_hollows(surface.mesh);
  return surface;
}

}  // namespace twrench::page
