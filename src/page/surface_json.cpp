#include "page/surface_json.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "page/packing.h"
#include "page/shadow_balls.h"
#include "picture/body/body_model.h"
#include "picture/body/revolution.h"
#include "picture/overlay/trail_point.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

ordered_json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
ordered_json numbers(const glm::vec3& v) { return {v.x, v.y, v.z}; }

/// Positions in units of radius / 32767, and normals.
std::string packed_vertices(const picture::Mesh& mesh, double radius) {
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

std::string packed_colors(const picture::Mesh& mesh) {
  std::vector<std::uint16_t> integers;
  for (const glm::vec3& color : mesh.colors) {
    for (const float x : {color.x, color.y, color.z}) {
      integers.push_back(
          static_cast<std::uint16_t>(std::lround(65535 * std::clamp(x, 0.0F, 1.0F))));
    }
  }
  return packed(integers, 3);
}

ordered_json capsules_json(const std::vector<picture::Capsule>& capsules) {
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

/// The uniforms of each part.
ordered_json parts_json(const Surface& surface, const Materials& materials) {
  ordered_json json = ordered_json::array();
  for (const picture::PartModel& part :
       picture::part_models(surface.parts, surface.mesh, surface.radius)) {
    ordered_json rows = ordered_json::array();
    for (const glm::vec4& row : part.across_from_body) {
      for (const float value : {row.x, row.y, row.z, row.w}) rows.push_back(value);
    }
    json.push_back({{"side_begin", part.side_begin},
                    {"end", part.end},
                    {"material", materials.of_part[json.size()]},
                    {"radii", numbers(part.radii)},
                    {"axis", numbers(part.side_axis)},
                    {"across", std::move(rows)},
                    {"occluders", capsules_json(part.occluders)}});
    if (part.mean_color) json.back()["tint"] = numbers(*part.mean_color);
  }
  return json;
}

ordered_json balls_json(const std::vector<picture::Ball>& balls) {
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
                    {"trail_point", numbers(picture::trail_point(scene))},
                    {"marked", picture::axis_of_revolution(parts).has_value()},
                    {"vertices", packed_vertices(mesh, radius)},
                    {"indices", packed(mesh.indices, 1)},
                    {"parts", parts_json(surface, materials)},
                    {"balls", balls_json(fewer_shadow_balls(scene::visible_parts(scene.body)))}};
  if (!mesh.colors.empty()) json["colors"] = packed_colors(mesh);
  return json;
}

}  // namespace twrench::page
