#include "page/surface_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "page/packing.h"
#include "page/shadow_balls.h"
#include "picture/body/body_model.h"
#include "picture/body/mark.h"
#include "picture/overlay/trail_point.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

ordered_json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
ordered_json numbers(const glm::vec3& v) { return {v.x, v.y, v.z}; }

void append(ordered_json& list, const ordered_json& values) {
  list.insert(list.end(), values.begin(), values.end());
}

/// Packs positions in units of radius / 32767, and normals.
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

/// The index ranges and the material of each part.
ordered_json parts_json(std::span<const picture::PartModel> parts, const Materials& materials) {
  ordered_json json = ordered_json::array();
  for (const picture::PartModel& part : parts) {
    json.push_back({{"side_begin", part.side_begin},
                    {"end", part.end},
                    {"material", materials.of_part[json.size()]}});
    if (part.mean_color) json.back()["tint"] = numbers(*part.mean_color);
  }
  return json;
}

/// The numbers from which the page's core computes uniforms, in the order of web/core/surfaces.cpp.
ordered_json model_json(std::span<const picture::PartModel> parts, double radius,
                        const std::vector<picture::Ball>& balls) {
  ordered_json json{radius, parts.size()};
  for (const picture::PartModel& part : parts) {
    append(json, numbers(part.radii));
    append(json, numbers(part.side_axis));
    for (const glm::vec4& row : part.across_from_body) append(json, {row.x, row.y, row.z, row.w});
    json.push_back(part.is_foil ? 1 : 0);
    json.push_back(part.occluders.size());
    for (const picture::Capsule& capsule : part.occluders) {
      append(json, numbers(capsule.from));
      append(json, numbers(capsule.to));
      append(json, {capsule.radius, capsule.meets ? 1 : 0, capsule.part});
    }
  }
  json.push_back(balls.size());
  for (const auto& [centre, ball_radius] : balls) {
    append(json, numbers(centre));
    json.push_back(ball_radius);
  }
  return json;
}

}  // namespace

ordered_json surface_json(const scene::Scene& scene, const Surface& surface,
                          const Materials& materials) {
  const auto& [parts, radius, mesh, simplification] = surface;
  const std::vector<picture::PartModel> models = picture::part_models(parts, mesh, radius);
  const auto balls = reduced_shadow_balls(scene::visible_parts(scene.body));
  ordered_json json{{"radius", radius},
                    {"trail_point", numbers(picture::trail_point(scene))},
                    {"vertices", packed_vertices(mesh, radius)},
                    {"indices", packed(mesh.indices, 1)},
                    {"parts", parts_json(models, materials)},
                    {"occluder_count", picture::most_occluders(models)},
                    {"model", model_json(models, radius, balls)}};
  if (!mesh.colors.empty()) json["colors"] = packed_colors(mesh);
  const auto principal = body::principal_axes(scene::mass_properties(scene.body).inertia);
  if (const auto mark = picture::mark_from_body(parts, materials.of_part, principal)) {
    json["mark"] = ordered_json::array();
    for (const glm::vec4& row : *mark) append(json["mark"], {row.x, row.y, row.z, row.w});
  }
  return json;
}

}  // namespace twrench::page
