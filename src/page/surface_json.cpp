#include "page/surface_json.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "page/packing.h"
#include "page/shadow_balls.h"
#include "render/body/mesh.h"
#include "render/body/occluders.h"
#include "render/body/outline_radii.h"
#include "render/body/revolution.h"
#include "render/overlay/trail_point.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

constexpr std::size_t most_occluders = 3;  // as in the film

ordered_json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Positions in units of radius / 32767, and normals.
std::string packed_vertices(const render::Mesh& mesh, double radius) {
  std::vector<std::uint16_t> integers;
  const auto add = [&](const glm::vec3& v, double scale) {
    for (const float x : {v.x, v.y, v.z}) {
      const auto value = static_cast<std::int16_t>(std::lround(scale * static_cast<double>(x)));
      integers.push_back(static_cast<std::uint16_t>(value));
    }
  };
  for (const auto& [position, normal] : mesh.vertices) {
    add(position, 32767 / radius);
    add(normal, 32767);
  }
  return packed(integers, 6);
}

std::string packed_colors(const render::Mesh& mesh) {
  std::vector<std::uint16_t> integers;
  for (const glm::vec3& color : mesh.colors) {
    for (const float x : {color.x, color.y, color.z}) {
      integers.push_back(
          static_cast<std::uint16_t>(std::lround(65535 * std::clamp(x, 0.0F, 1.0F))));
    }
  }
  return packed(integers, 3);
}

/// The mean colour of the vertices of a part.
ordered_json tint_json(const render::Mesh& mesh, std::size_t part) {
  const std::size_t begin = part == 0 ? 0 : mesh.vertex_ends[part - 1];
  glm::vec3 sum(0);
  for (std::size_t i = begin; i < mesh.vertex_ends[part]; ++i) sum += mesh.colors[i];
  sum /= static_cast<float>(mesh.vertex_ends[part] - begin);
  return {sum.x, sum.y, sum.z};
}

ordered_json capsules_json(const std::vector<render::Capsule>& capsules) {
  ordered_json json = ordered_json::array();
  for (const auto& [from, to, radius, meets, part] : capsules) {
    json.push_back({{"from", numbers(from)},
                    {"to", numbers(to)},
                    {"radius", radius},
                    {"meets", meets},
                    {"part", part}});
  }
  return json;
}

/// The uniforms of each part; see render/body/body_pass.cpp.
ordered_json parts_json(std::span<const body::Part> parts, const render::Mesh& mesh,
                        const Materials& materials, double radius) {
  const auto occluders = render::find_occluders(parts, most_occluders);
  const auto across = render::across_from_body(parts);
  ordered_json json = ordered_json::array();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& side = mesh.sides[i];
    const render::OutlineRadii outline = render::outline_radii(parts[i].shape);
    const Vector3d axis = side ? Vector3d(parts[i].body_from_part.col(2)) : Vector3d::Zero();
    ordered_json rows = ordered_json::array();
    for (const glm::vec4& row : across[i]) {
      for (const float value : {row.x, row.y, row.z, row.w}) rows.push_back(value);
    }
    json.push_back(
        {{"side_begin", side ? side->begin : mesh.part_ends[i]},
         {"end", mesh.part_ends[i]},
         {"material", materials.of_part[i]},
         {"radii",
          {outline.radius / radius, outline.round / radius, side ? side->bevel / radius : 0}},
         {"axis", numbers(axis)},
         {"across", std::move(rows)},
         {"occluders", capsules_json(occluders[i])}});
    if (mesh.is_colored[i] != 0) json.back()["tint"] = tint_json(mesh, i);
  }
  return json;
}

ordered_json balls_json(const std::vector<render::Ball>& balls) {
  ordered_json json = ordered_json::array();
  for (const auto& [centre, radius] : balls) {
    json.push_back({{"centre", numbers(centre)}, {"radius", radius}});
  }
  return json;
}

}  // namespace

ordered_json surface_json(const scene::Scene& scene, const Surface& surface,
                          const Materials& materials) {
  const auto& [parts, radius, mesh, simplification] = surface;
  ordered_json json{{"radius", radius},
                    {"trail_point", numbers(render::trail_point(scene))},
                    {"marked", render::axis_of_revolution(parts).has_value()},
                    {"vertices", packed_vertices(mesh, radius)},
                    {"indices", packed(mesh.indices, 1)},
                    {"parts", parts_json(parts, mesh, materials, radius)},
                    {"balls", balls_json(fewer_shadow_balls(scene::visible_parts(scene.body)))}};
  if (!mesh.colors.empty()) json["colors"] = packed_colors(mesh);
  return json;
}

}  // namespace twrench::page
