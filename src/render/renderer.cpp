#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <utility>

#include "gl/framebuffer.h"
#include "render/background.h"
#include "render/body_pass.h"
#include "render/camera.h"
#include "render/glm_from_eigen.h"
#include "render/joined_parts.h"
#include "render/layer.h"
#include "render/mesh.h"
#include "render/reach.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;

Camera camera_of(const Scene& scene, double radius) {
  return frame_sphere({scene.look.camera, scene.look.field_of_view,
                       static_cast<double>(scene.film.width) / scene.film.height, radius});
}

/// A mesh whose facets cannot be told from the shape's: a fifth of a pixel in the picture's middle.
Mesh mesh_of(const Scene& scene, const Camera& camera) {
  const double pixel = 2 * camera.distance / (camera.projection(1, 1) * scene.film.height);  // cm
  return body_mesh(joined_parts(visible_parts(scene.body)), 0.2 * pixel);
}

/// The pixels from `low` to `high`, which are device coordinates, with one more on each side for
/// what GL may round otherwise.
std::pair<int, int> pixels_between(float low, float high, int size) {
  const auto pixel = [size](float place) {
    const double exact = (0.5 + 0.5 * static_cast<double>(place)) * size;
    return static_cast<int>(std::clamp<double>(std::floor(exact), -2, size + 2));
  };
  const int first = std::clamp(pixel(low) - 1, 0, size - 1);
  const int end = std::clamp(pixel(high) + 2, first + 1, size);
  return {first, end - first};
}

}  // namespace

struct Renderer::Parts {
  Parts(gl::Context& context, const Scene& scene);

  /// The smallest rectangle that holds the body, or all when some of it is behind the eye.
  gl::Rectangle body_area(const Matrix3d& X) const;
  Image draw(const Matrix3d& X) const;

  gl::Functions gl;
  double radius;  // cm, of the sphere that holds the body in every pose
  Camera camera;
  Mesh mesh;
  gl::Framebuffer framebuffer;
  BodyPass body;
  std::optional<Image> behind;  // none where the film is transparent
};

Renderer::Parts::Parts(gl::Context& context, const Scene& scene)
    : gl(context),
      radius(reach(visible_parts(scene.body))),
      camera(camera_of(scene, radius)),
      mesh(mesh_of(scene, camera)),
      framebuffer(gl, scene.film.width, scene.film.height, scene.look.samples),
      body(gl, mesh, radius, camera, material(scene.look), dark_studio()) {
  if (!scene.look.transparent) {
    behind = background(scene.look, scene.film.width, scene.film.height);
  }
}

gl::Rectangle Renderer::Parts::body_area(const Matrix3d& X) const {
  Matrix4d space_from_body = Matrix4d::Identity();
  space_from_body.topLeftCorner<3, 3>() = X;
  const glm::mat4 clip_from_body =
      glm_from_eigen((camera.projection * camera.view * space_from_body).eval());
  glm::vec2 low(1);
  glm::vec2 high(-1);
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec4 p = clip_from_body * glm::vec4(vertex.position, 1);
    if (p.w <= 0) return {0, 0, framebuffer.width(), framebuffer.height()};
    low = glm::min(low, glm::vec2(p) / p.w);
    high = glm::max(high, glm::vec2(p) / p.w);
  }
  const auto [x, width] = pixels_between(low.x, high.x, framebuffer.width());
  const auto [y, height] = pixels_between(low.y, high.y, framebuffer.height());
  return {x, y, width, height};
}

Image Renderer::Parts::draw(const Matrix3d& X) const {
  const gl::Rectangle area = body_area(X);
  framebuffer.draw_within(area);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  body.draw(X);
  const Image layer = framebuffer.read(area);
  const int top = framebuffer.height() - area.y - area.height;
  if (!behind) {
    return lay_on_nothing(framebuffer.width(), framebuffer.height(), layer, area.x, top);
  }
  Image image = *behind;
  lay_over(image, layer, area.x, top);
  return image;
}

Renderer::Renderer(gl::Context& context, const Scene& scene)
    : parts_(std::make_unique<Parts>(context, scene)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::draw(const Matrix3d& X) { return parts_->draw(X); }
std::string Renderer::description() const { return gl::renderer_string(parts_->gl); }
Matrix4d Renderer::view() const { return parts_->camera.view; }
Matrix4d Renderer::projection() const { return parts_->camera.projection; }

}  // namespace twrench
