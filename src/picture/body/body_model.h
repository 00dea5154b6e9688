#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "picture/body/intersections.h"
#include "picture/body/mark.h"
#include "picture/body/mesh.h"
#include "picture/body/occluders.h"
#include "picture/body/revolution.h"
#include "picture/look/material.h"
#include "picture/look/studio.h"
#include "scene/scene.h"

namespace twrench::picture {

/// A part of a body as its shaders need it. The shaders are in stage coordinates: the camera's
/// axes, with the body's centre at the origin and its bounding radius scaled to 1.
struct PartModel {
  /// In the mesh's indices: where the side of a cylinder begins, or the end of a part without one.
  std::size_t side_begin;
  /// In the mesh's indices.
  std::size_t end;
  /// The uniform part_radii of body.vert, in stage coordinates.
  glm::vec3 radii;
  /// Unit vector in body axes; 0 for a part without the side of a cylinder.
  Eigen::Vector3d side_axis;
  /// Whether it is foil on another part, over which it is drawn.
  bool is_foil = false;
  /// The uniform across_from_body of body.vert.
  AcrossFromBody across_from_body;
  /// The nearest capsules of other parts, at most three: more would cost more at every pixel than
  /// they add to the picture.
  std::vector<Capsule> occluders;
  /// Linear mean of the colours of its vertices, if they have any.
  std::optional<glm::vec3> mean_color;

  /// Whether it is lifted over a part that is drawn before it and that it touches.
  bool is_lifted() const;
};

/// Returns the parts of a body with that mesh, whose bounding radius about the origin is `radius`
/// cm.
std::vector<PartModel> part_models(std::span<const body::Part> parts, const Mesh& mesh,
                                   double radius);

/// The body as it is drawn.
struct BodyModel {
  /// Triangles of all parts.
  Mesh mesh;
  /// Bounding radius of the parts about the origin, cm.
  double radius;
  /// The parts, in the order of the mesh's.
  std::vector<PartModel> parts;
  /// Edges along which the parts enter each other.
  PartIntersections intersections;
  /// The material of each part.
  std::vector<Material> materials;
  /// The linear colour of the light that each part reflects.
  std::vector<glm::vec3> tints;
  /// The paint that shows how the body turns, if it needs any.
  std::optional<MarkFromBody> mark;
  /// The largest number of occluders of a part.
  std::size_t occluder_count;
  /// Lights.
  Studio studio;
};

/// Returns the largest number of occluders of a part.
std::size_t most_occluders(std::span<const PartModel> parts);

/// Returns the body of these parts without a mark, each with its material.
BodyModel body_model(std::span<const body::Part> parts, Mesh mesh, double radius,
                     std::vector<Material> materials, const Studio& studio);

/// Returns the body of the scene with facets that deviate from it by at most `tolerance` cm.
/// `radius` is the bounding radius of its visible parts about the origin in cm.
BodyModel body_model(const scene::Scene& scene, double tolerance, double radius);

}  // namespace twrench::picture
