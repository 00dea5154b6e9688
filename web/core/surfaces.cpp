// Computes the uniforms with which the page draws a body and the floor below it, and the box of a
// body given by its moments.

#include <twrench/body/mass_properties.h>

#include <cmath>
#include <random>
#include <vector>

#include "picture/body/body_uniforms.h"
#include "picture/body/floor_plane.h"
#include "picture/body/mark.h"
#include "picture/body/shadow_balls.h"
#include "picture/overlay/trail_point.h"
#include "picture/shapes/shapes.h"
#include "picture/space/glm_from_eigen.h"
#include "scratch.h"

namespace twrench::page {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using picture::Ball;
using picture::BodyModel;
using picture::Camera;
using picture::Capsule;
using picture::PartModel;

/// A body without the mesh and the materials of its model, which JavaScript holds.
struct Surface {
  BodyModel body;
  std::vector<Ball> balls;  ///< They cast its shadow.
};

/// The last results, as the floats that the shaders need.
std::vector<float> uniforms;

void add(const glm::vec3& v) { uniforms.insert(uniforms.end(), {v.x, v.y, v.z}); }
void add(const glm::vec4& v) { uniforms.insert(uniforms.end(), {v.x, v.y, v.z, v.w}); }
template <typename Matrix>
void add_columns(const Matrix& m) {
  for (int i = 0; i < Matrix::length(); ++i) add(m[i]);
}

const float* written() {
  Results(1) << static_cast<double>(uniforms.size());
  return uniforms.data();
}

/// Reads a camera: its attitude, camera_from_space, the distance and the projection.
Camera read_camera(Arguments& arguments) {
  Camera camera;
  camera.view.topLeftCorner<3, 3>() = arguments.matrix();
  camera.distance = arguments.number();
  camera.view(2, 3) = -camera.distance;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) camera.projection(row, column) = arguments.number();
  }
  return camera;
}

PartModel read_part(Arguments& arguments) {
  PartModel part{};
  part.radii = picture::glm_from_eigen(arguments.vector());
  part.side_axis = arguments.vector();
  for (glm::vec4& row : part.across_from_body) {
    for (int i = 0; i < 4; ++i) row[i] = static_cast<float>(arguments.number());
  }
  part.is_foil = arguments.number() != 0;
  const std::size_t occluders = arguments.count();
  for (std::size_t i = 0; i < occluders; ++i) {
    Capsule capsule{};
    capsule.from = arguments.vector();
    capsule.to = arguments.vector();
    capsule.radius = arguments.number();
    capsule.meets = arguments.number() != 0;
    capsule.part = arguments.count();
    part.occluders.push_back(capsule);
  }
  return part;
}

}  // namespace
}  // namespace twrench::page

extern "C" {

using namespace twrench;
using namespace twrench::page;

/// Creates the body whose bounding radius, parts and balls are in the scratch area, followed by the
/// tint of each part.
[[clang::export_name("surface_new")]] Surface* surface_new() {
  Arguments arguments;
  auto* surface = new Surface{};
  surface->body.radius = arguments.number();
  const std::size_t parts = arguments.count();
  for (std::size_t i = 0; i < parts; ++i) surface->body.parts.push_back(read_part(arguments));
  surface->body.occluder_count = picture::most_occluders(surface->body.parts);
  const std::size_t balls = arguments.count();
  for (std::size_t i = 0; i < balls; ++i) {
    const Vector3d centre = arguments.vector();
    surface->balls.push_back({centre, arguments.number()});
  }
  for (std::size_t i = 0; i < parts; ++i) {
    surface->body.tints.push_back(picture::glm_from_eigen(arguments.vector()));
  }
  return surface;
}

/// Writes the box of a body with the moments in the scratch area: the addresses of its vertices and
/// indices, and their numbers; the point that draws the trail; the rows of its mark; then the
/// arguments of surface_new() without the tint. Returns how many numbers these are.
[[clang::export_name("box_surface")]] std::size_t box_surface() {
  static picture::Mesh mesh;
  scene::Scene scene;
  const Matrix3d inertia = vector_at(0).asDiagonal();
  const body::Part part = body::equimomental_box(inertia);
  scene.body.parts = {part};
  const picture::MarkFromBody mark =
      picture::painted_end(scene.body.parts, body::principal_axes(inertia));
  const auto& box = std::get<body::Box>(part.shape);
  const double radius = box.size.norm() / 2;
  mesh = picture::surface_of_rings(part, picture::rings_of(box, 2.3e-4 * radius));
  const picture::ShapeTraits traits = picture::traits(box);
  const Vector3d end = traits.occluder->half_length * Vector3d::Unit(traits.occluder->axis);
  Results results(0);
  results << mesh.vertices.data() << static_cast<double>(mesh.vertices.size())
          << mesh.indices.data() << static_cast<double>(mesh.indices.size())
          << picture::trail_point(scene);
  for (const glm::vec4& row : mark) {
    for (int i = 0; i < 4; ++i) results << row[i];
  }
  results << radius << 1.0 << Vector3d(traits.outline.radius / radius, 0, 0);
  // No side of a cylinder, not foil, no occluders.
  for (int i = 0; i < 3 + 8 + 1 + 1; ++i) results << 0.0;
  const std::vector<Ball> balls = picture::shadow_balls({-end, end, traits.occluder->radius});
  results << static_cast<double>(balls.size());
  for (const auto& [centre, ball_radius] : balls) results << centre << ball_radius;
  return results.count();
}

[[clang::export_name("surface_free")]] void surface_free(const Surface* surface) { delete surface; }

/// Writes the uniforms of a body with the camera and the attitude X in the scratch area, or of its
/// reflection in the floor: those of all parts, then those of each.
[[clang::export_name("surface_uniforms")]] const float* surface_uniforms(const Surface* surface,
                                                                         bool mirrored) {
  Arguments arguments;
  const Camera camera = read_camera(arguments);
  const Matrix3d X = arguments.matrix();
  const auto& [body, balls] = *surface;
  const picture::StageUniforms stage =
      mirrored ? picture::mirrored_stage_uniforms(camera, X, body.radius,
                                                  picture::floor_height(body.radius))
               : picture::stage_uniforms(camera, X, body.radius);
  uniforms.clear();
  add(stage.eye);
  add_columns(stage.clip_from_stage);
  add_columns(stage.stage_from_body);
  add_columns(stage.stage_normal_from_body);
  for (const PartModel& part : body.parts) {
    uniforms.push_back(!mirrored && part.is_lifted() ? 1 : 0);
    uniforms.push_back(part.is_foil ? 0 : 1);
    add(part.radii);
    add(picture::side_axis_in_stage(body, part, camera, X));
    for (const glm::vec4& row : part.across_from_body) add(row);
    const auto [from, to, tint] = picture::occluder_uniforms(body, part, camera, X, !mirrored);
    for (const auto* values : {&from, &to, &tint}) {
      for (const glm::vec4& value : *values) add(value);
    }
  }
  return written();
}

/// Writes the uniforms of the floor below it: floor_from_place, right_and_height, and the balls.
[[clang::export_name("floor_uniforms")]] const float* floor_uniforms(const Surface* surface) {
  Arguments arguments;
  const Camera camera = read_camera(arguments);
  const Matrix3d X = arguments.matrix();
  const double radius = surface->body.radius;
  const double height = picture::floor_height(radius);
  uniforms.clear();
  add_columns(picture::glm_from_eigen(picture::floor_from_device(camera, radius)));
  const Eigen::Vector2d right(camera.view(0, 0), camera.view(0, 2));
  add(glm::vec4(right.x() / right.norm(), right.y() / right.norm(), height / radius, 0));
  for (const Ball& ball : surface->balls) {
    const Vector3d centre = (X * ball.centre - Vector3d(0, height, 0)) / radius;
    add(glm::vec4(picture::glm_from_eigen(centre), ball.radius / radius));
  }
  return written();
}

}  // extern "C"
