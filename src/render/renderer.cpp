#include "render/renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "embedded/shaders.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/background.h"
#include "render/camera.h"
#include "render/glm_from_eigen.h"
#include "render/joined_parts.h"
#include "render/layer.h"
#include "render/material.h"
#include "render/mesh.h"
#include "render/studio.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;

gl::Program body_program(const gl::Functions& gl) {
  const auto file = [](const char* name) {
    return gl::ShaderFile{name, embedded::shaders().at(name)};
  };
  const std::array vertex{file("body.vert")};
  const std::array fragment{file("area_light.glsl"), file("tone.glsl"), file("body.frag")};
  return {gl, vertex, fragment};
}

double bounding_radius(const Mesh& mesh) {
  float radius = 0;
  for (const Vertex& vertex : mesh.vertices)
    radius = std::max(radius, glm::length(vertex.position));
  return radius;
}

void set_material(const gl::Program& program, const Material& material) {
  program.set("diffuse", material.diffuse);
  program.set("reflectance", material.reflectance);
  program.set("alpha", material.alpha);
}

void set_studio(const gl::Program& program, const Studio& studio) {
  std::array<glm::vec3, Studio::light_count> centre, across, along, radiance;
  std::array<glm::vec2, Studio::light_count> half_size;
  for (std::size_t i = 0; i < studio.lights.size(); ++i) {
    const AreaLight& light = studio.lights[i];
    centre[i] = light.centre;
    half_size[i] = {glm::length(light.across), glm::length(light.along)};
    across[i] = light.across / half_size[i].x;
    along[i] = light.along / half_size[i].y;
    radiance[i] = light.radiance;
  }
  program.set("light_centre", centre);
  program.set("light_across", across);
  program.set("light_along", along);
  program.set("light_half_size", half_size);
  program.set("light_radiance", radiance);
  program.set("room_above", studio.above);
  program.set("room_below", studio.below);
}

/// Takes normals to where the matrix takes the surface: its cofactors, which for a rotation are
/// the rotation itself, and are right too for a pose that has left SO(3).
Matrix3d normal_matrix(const Matrix3d& m) {
  Matrix3d cofactors;
  cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
  return cofactors;
}

/// The mesh in GL's memory.
class DrawnMesh {
 public:
  DrawnMesh(const gl::Functions& gl, const Mesh& mesh)
      : gl_(&gl),
        array_(gl),
        vertices_(gl),
        indices_(gl),
        count_(static_cast<GLsizei>(mesh.indices.size())) {
    gl.BindVertexArray(array_.id());
    upload(GL_ARRAY_BUFFER, vertices_, std::as_bytes(std::span(mesh.vertices)));
    upload(GL_ELEMENT_ARRAY_BUFFER, indices_, std::as_bytes(std::span(mesh.indices)));
    attribute(0, offsetof(Vertex, position));
    attribute(1, offsetof(Vertex, normal));
  }

  void draw() const {
    gl_->BindVertexArray(array_.id());
    gl_->DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  }

 private:
  void upload(GLenum target, const gl::Buffer& buffer, std::span<const std::byte> bytes) const {
    gl_->BindBuffer(target, buffer.id());
    gl_->BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  }
  void attribute(GLuint location, std::size_t offset) const {
    gl_->EnableVertexAttribArray(location);
    gl_->VertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                             reinterpret_cast<const void*>(offset));
  }

  const gl::Functions* gl_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
  GLsizei count_;
};

}  // namespace

struct Renderer::Parts {
  Parts(gl::Context& context, const Scene& scene);

  gl::Rectangle screen_area(const Matrix4d& clip_from_body) const;
  Image draw(const Matrix3d& X);

  gl::Functions gl;
  bool transparent;
  Mesh mesh;
  double radius;
  Camera camera;
  gl::Framebuffer framebuffer;
  gl::Program program;
  DrawnMesh drawn_mesh;
  Image behind;
};

namespace {

Camera camera_of(const Scene& scene, double radius) {
  return frame_sphere({scene.look.camera, scene.look.field_of_view,
                       static_cast<double>(scene.film.width) / scene.film.height, radius});
}

}  // namespace

Renderer::Parts::Parts(gl::Context& context, const Scene& scene)
    : gl(context),
      transparent(scene.look.transparent),
      mesh(body_mesh(joined_parts(visible_parts(scene.body)))),
      radius(bounding_radius(mesh)),
      camera(camera_of(scene, radius)),
      framebuffer(gl, scene.film.width, scene.film.height, scene.look.samples),
      program(body_program(gl)),
      drawn_mesh(gl, mesh) {
  if (!transparent) behind = background(scene.look, scene.film.width, scene.film.height);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
  program.use();
  set_material(program, material(scene.look));
  set_studio(program, dark_studio());
  program.set("eye", glm::vec3(0, 0, static_cast<float>(camera.distance / radius)));
}

gl::Rectangle Renderer::Parts::screen_area(const Matrix4d& clip_from_body) const {
  const glm::mat4 clip = glm_from_eigen(clip_from_body);
  glm::vec2 low(1), high(-1);
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec4 p = clip * glm::vec4(vertex.position, 1);
    if (p.w <= 0) return {0, 0, framebuffer.width(), framebuffer.height()};
    const glm::vec2 place = glm::vec2(p) / p.w;
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  // One pixel more on each side, for what the floats of GL round otherwise.
  const auto pixel = [](float ndc, int size, int extra) {
    const double place = (0.5 + 0.5 * static_cast<double>(ndc)) * size;
    return std::clamp(static_cast<int>(std::floor(place)) + extra, 0, size);
  };
  const int left = std::min(pixel(low.x, framebuffer.width(), -1), framebuffer.width() - 1);
  const int bottom = std::min(pixel(low.y, framebuffer.height(), -1), framebuffer.height() - 1);
  return {left, bottom, std::max(pixel(high.x, framebuffer.width(), 2) - left, 1),
          std::max(pixel(high.y, framebuffer.height(), 2) - bottom, 1)};
}

Image Renderer::Parts::draw(const Matrix3d& X) {
  const Matrix3d camera_from_body = camera.camera_from_space() * X;
  Matrix4d camera_from_stage = Matrix4d::Identity() * radius;
  camera_from_stage.col(3) = camera.view.col(3);
  camera_from_stage(3, 3) = 1;
  Matrix4d space_from_body = Matrix4d::Identity();
  space_from_body.topLeftCorner<3, 3>() = X;
  const gl::Rectangle area = screen_area(camera.projection * camera.view * space_from_body);

  program.use();
  program.set("stage_from_body", glm_from_eigen((camera_from_body / radius).eval()));
  program.set("stage_normal_from_body", glm_from_eigen(normal_matrix(camera_from_body)));
  program.set("clip_from_stage", glm_from_eigen((camera.projection * camera_from_stage).eval()));
  framebuffer.draw_within(area);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  drawn_mesh.draw();

  const Image layer = framebuffer.read(area);
  const int top = framebuffer.height() - area.y - area.height;
  if (transparent) {
    return lay_on_nothing(framebuffer.width(), framebuffer.height(), layer, area.x, top);
  }
  Image image = behind;
  lay_over(image, layer, area.x, top);
  return image;
}

Renderer::Renderer(gl::Context& context, const Scene& scene)
    : parts_(std::make_unique<Parts>(context, scene)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::draw(const Matrix3d& X) { return parts_->draw(X); }
Matrix4d Renderer::view() const { return parts_->camera.view; }
Matrix4d Renderer::projection() const { return parts_->camera.projection; }

}  // namespace twrench
