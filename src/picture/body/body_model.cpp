#include "picture/body/body_model.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "picture/body/gap_closing.h"
#include "picture/body/hollows.h"
#include "picture/look/theme.h"
#include "picture/shapes/shapes.h"
#include "picture/space/glm_from_eigen.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

constexpr std::size_t max_occluders = 3;

std::optional<glm::vec3> mean_color(const Mesh& mesh, std::size_t part) {
  if (mesh.is_colored[part] == 0) return std::nullopt;
  const std::size_t begin = part == 0 ? 0 : mesh.vertex_ends[part - 1];
  const std::size_t end = mesh.vertex_ends[part];
  const auto at = [&](std::size_t i) {
    return mesh.colors.begin() + static_cast<std::ptrdiff_t>(i);
  };
  return std::accumulate(at(begin), at(end), glm::vec3(0)) / static_cast<float>(end - begin);
}

/// Returns for each part the index of the first with the same material.
std::vector<std::size_t> first_alike(const std::vector<Material>& materials) {
  std::vector<std::size_t> first;
  for (const Material& material : materials) {
    const auto found = std::ranges::find(materials, material);
    first.push_back(static_cast<std::size_t>(found - materials.begin()));
  }
  return first;
}

}  // namespace

bool PartModel::is_lifted() const {
  return is_foil || std::ranges::any_of(occluders, &Capsule::meets);
}

std::vector<PartModel> part_models(std::span<const body::Part> parts, const Mesh& mesh,
                                   double radius) {
  std::vector<std::vector<Capsule>> occluders = find_occluders(parts, max_occluders);
  const std::vector<AcrossFromBody> across = across_from_body(parts);
  std::vector<PartModel> models;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<CylinderSide>& side = mesh.sides[i];
    const auto [outline, round] = traits_of(parts[i].shape).outline;
    const double rim = side ? side->bevel : 0;
    models.push_back(
        {.side_begin = side ? side->begin : mesh.part_ends[i],
         .end = mesh.part_ends[i],
         .radii = glm_from_eigen((Vector3d(outline, round, rim) / radius).eval()),
         .side_axis = side ? Vector3d(parts[i].body_from_part.col(2)) : Vector3d::Zero(),
         .is_foil = traits_of(parts[i].shape).is_foil,
         .across_from_body = across[i],
         .occluders = std::move(occluders[i]),
         .mean_color = mean_color(mesh, i)});
  }
  return models;
}

std::size_t most_occluders(std::span<const PartModel> parts) {
  std::size_t most = 0;
  for (const PartModel& part : parts) most = std::max(most, part.occluders.size());
  return most;
}

BodyModel body_model(std::span<const body::Part> parts, Mesh mesh, double radius,
                     std::vector<Material> materials, const Studio& studio) {
  std::vector<PartModel> models = part_models(parts, mesh, radius);
  const std::size_t occluders = most_occluders(models);
  PartIntersections intersections = find_intersections(mesh, models);
  std::vector<glm::vec3> tints;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (mesh.sides[i] && !intersections[i].empty()) mesh.sides[i]->most_merged = 1;
    tints.push_back(models[i].mean_color.value_or(glm::vec3(1)) *
                    (materials[i].diffuse + materials[i].reflectance));
  }
  return {.mesh = std::move(mesh),
          .radius = radius,
          .parts = std::move(models),
          .intersections = std::move(intersections),
          .materials = std::move(materials),
          .tints = std::move(tints),
          .mark = std::nullopt,
          .occluder_count = occluders,
          .studio = studio};
}

BodyModel body_model(const scene::Scene& scene, double tolerance, double radius) {
  const std::vector<body::Part> parts = close_gaps(scene::visible_parts(scene.body));
  std::vector<scene::PartLook> looks;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    looks.push_back(scene::description(scene.body, i).look);
  }
  Mesh mesh = body_mesh(parts, tolerance, looks);
  shade_hollows(mesh);
  std::vector<Material> materials;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    materials.push_back(material(scene.look, looks[i], has_own_colors(parts[i])));
  }
  const auto mark =
      mark_from_body(parts, first_alike(materials),
                     body::principal_axes(scene::mass_properties(scene.body).inertia));
  BodyModel model = body_model(parts, std::move(mesh), radius, std::move(materials),
                               style_of(scene.look.theme).studio);
  model.mark = mark;
  return model;
}

}  // namespace twrench::picture
