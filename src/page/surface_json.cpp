#include "page/surface_json.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "render/body/bounding_radius.h"
#include "render/body/gap_closing.h"
#include "render/body/mesh.h"
#include "render/body/occluders.h"
#include "render/body/revolution.h"
#include "render/overlay/trail_point.h"
#include "system/base64.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

constexpr std::size_t most_occluders = 3;    // as in the film
constexpr std::size_t most_vertices = 5000;  // of bodies of few parts, for the size of the page
constexpr double finest = 2.3e-4;            // tolerance in radii: invisible in 1440 rows
constexpr double coarsest = 2e-3;
constexpr double most_gaps = 60;  // between the balls of a part that casts shadow

ordered_json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

template <typename Integer>
std::string packed(const std::vector<Integer>& integers) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(integers.size() * sizeof(Integer));
  for (const Integer value : integers) {
    const auto bits = static_cast<std::uint32_t>(value);
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
    }
  }
  return system::base64(bytes);
}

std::string packed_vertices(const render::Mesh& mesh, double radius) {
  std::vector<std::int16_t> integers;
  const auto add = [&](const glm::vec3& v, double scale) {
    for (const float x : {v.x, v.y, v.z}) {
      integers.push_back(static_cast<std::int16_t>(std::lround(scale * static_cast<double>(x))));
    }
  };
  for (const auto& [position, normal] : mesh.vertices) {
    add(position, 32767 / radius);
    add(normal, 32767);
  }
  return packed(integers);
}

std::string packed_indices(const render::Mesh& mesh, bool wide) {
  if (wide) return packed(mesh.indices);
  return packed(std::vector<std::uint16_t>(mesh.indices.begin(), mesh.indices.end()));
}

/// As fine as a page may be large.
render::Mesh surface_of(std::span<const body::Part> parts, double radius) {
  double tolerance = finest * radius;
  render::Mesh mesh = render::body_mesh(parts, tolerance);
  while (mesh.vertices.size() > most_vertices && tolerance < coarsest * radius) {
    tolerance *= 1.5;
    mesh = render::body_mesh(parts, tolerance);
  }
  return mesh;
}

ordered_json capsules_json(const std::vector<render::Capsule>& capsules) {
  ordered_json json = ordered_json::array();
  for (const auto& [from, to, radius, meets] : capsules) {
    json.push_back(
        {{"from", numbers(from)}, {"to", numbers(to)}, {"radius", radius}, {"meets", meets}});
  }
  return json;
}

/// The uniforms of each part; see render/body/body_pass.cpp.
ordered_json parts_json(std::span<const body::Part> parts, const render::Mesh& mesh,
                        double radius) {
  const auto occluders = render::find_occluders(parts, most_occluders);
  const auto across = render::across_from_body(parts);
  ordered_json json = ordered_json::array();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& side = mesh.sides[i];
    const double thickness = render::capsule_of(parts[i]).radius / radius;
    const bool is_round = std::holds_alternative<body::Ellipsoid>(parts[i].shape);
    const Vector3d axis = side ? Vector3d(parts[i].body_from_part.col(2)) : Vector3d::Zero();
    ordered_json rows = ordered_json::array();
    for (const glm::vec4& row : across[i]) {
      for (const float value : {row.x, row.y, row.z, row.w}) rows.push_back(value);
    }
    json.push_back(
        {{"side_begin", side ? side->begin : mesh.part_ends[i]},
         {"end", mesh.part_ends[i]},
         {"material", 0},
         {"radii", {thickness, is_round ? thickness : 0, side ? side->bevel / radius : 0}},
         {"axis", numbers(axis)},
         {"across", std::move(rows)},
         {"occluders", capsules_json(occluders[i])}});
  }
  return json;
}

/// Spheres that cast as much shadow as the parts; see render/body/floor.cpp.
ordered_json balls_json(std::span<const body::Part> parts) {
  ordered_json json = ordered_json::array();
  for (const body::Part& part : parts) {
    const auto [from, to, radius, meets] = render::capsule_of(part);
    const double apart = std::numbers::pi / 2 * radius;
    const int gaps = static_cast<int>(std::lround(std::min((to - from).norm() / apart, most_gaps)));
    for (int i = 0; i <= gaps; ++i) {
      const Vector3d centre = from + (gaps > 0 ? double(i) / gaps : 0.5) * (to - from);
      json.push_back({{"centre", numbers(centre)}, {"radius", radius}});
    }
  }
  return json;
}

}  // namespace

ordered_json surface_json(const scene::Scene& scene) {
  const std::vector<body::Part> visible = scene::visible_parts(scene.body);
  const std::vector<body::Part> parts = render::close_gaps(visible);
  const double radius = render::bounding_radius(visible);
  const render::Mesh mesh = surface_of(parts, radius);
  const bool wide = mesh.vertices.size() > 65536;
  return {{"radius", radius},
          {"trail_point", numbers(render::trail_point(scene))},
          {"marked", render::axis_of_revolution(parts).has_value()},
          {"vertices", packed_vertices(mesh, radius)},
          {"wide_indices", wide},
          {"indices", packed_indices(mesh, wide)},
          {"parts", parts_json(parts, mesh, radius)},
          {"balls", balls_json(visible)}};
}

}  // namespace twrench::page
