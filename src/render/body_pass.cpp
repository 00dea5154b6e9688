#include "render/body_pass.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <span>

#include "embedded/shaders.h"
#include "render/glm_from_eigen.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;

bool scatters(const Material& material) { return material.diffuse != glm::vec3(0); }

/// Whether the body scatters is compiled in, not asked at each pixel: llvmpipe takes both ways of
/// an if, and the second doubles the work.
gl::Program body_program(const gl::Functions& gl, const Material& material) {
  const auto file = [](const char* name) {
    return gl::ShaderFile{name, embedded::shaders().at(name)};
  };
  const std::array vertex{file("body.vert")};
  const std::array fragment{file("studio.glsl"), file("tone.glsl"),
                            file(scatters(material) ? "matte.glsl" : "metal.glsl"),
                            file("body.frag")};
  return {gl, vertex, fragment};
}

void upload(const gl::Functions& gl, GLenum target, const gl::Buffer& buffer,
            std::span<const std::byte> bytes) {
  gl.BindBuffer(target, buffer.id());
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
}

void set_attribute(const gl::Functions& gl, BodyAttribute attribute, std::size_t offset) {
  gl.EnableVertexAttribArray(attribute);
  gl.VertexAttribPointer(
      attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
      // GL takes an offset for a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
      reinterpret_cast<const void*>(offset));
}

/// Takes normals to where the matrix takes the surface: its cofactors, which for a rotation are
/// the rotation itself, and which are right too for a pose that has left SO(3).
Matrix3d normal_matrix(const Matrix3d& m) {
  Matrix3d cofactors;
  cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
  return cofactors;
}

Matrix4d camera_from_stage(const Camera& camera, double radius) {
  Matrix4d result = Matrix4d::Identity();
  result.topLeftCorner<3, 3>() *= radius;
  result(2, 3) = -camera.distance;
  return result;
}

}  // namespace

BodyPass::BodyPass(const gl::Functions& gl, const Mesh& mesh, double radius,
                   const Material& material, const Studio& studio)
    : gl_(&gl),
      program_(body_program(gl, material)),
      array_(gl),
      vertices_(gl),
      indices_(gl),
      index_count_(static_cast<GLsizei>(mesh.indices.size())),
      radius_(radius) {
  gl.BindVertexArray(array_.id());
  upload(gl, GL_ARRAY_BUFFER, vertices_, std::as_bytes(std::span(mesh.vertices)));
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, indices_, std::as_bytes(std::span(mesh.indices)));
  set_attribute(gl, position_attribute, offsetof(Vertex, position));
  set_attribute(gl, normal_attribute, offsetof(Vertex, normal));

  program_.use();
  set_material(material);
  set_studio(studio);
}

void BodyPass::draw(const Camera& camera, const Matrix3d& X) const {
  const Matrix3d camera_from_body = camera.camera_from_space() * X;
  program_.use();
  program_.set("eye", glm::vec3(0, 0, static_cast<float>(camera.distance / radius_)));
  program_.set("clip_from_stage",
               glm_from_eigen((camera.projection * camera_from_stage(camera, radius_)).eval()));
  program_.set("stage_from_body", glm_from_eigen((camera_from_body / radius_).eval()));
  program_.set("stage_normal_from_body", glm_from_eigen(normal_matrix(camera_from_body)));
  gl_->Enable(GL_DEPTH_TEST);
  gl_->Enable(GL_CULL_FACE);
  gl_->BindVertexArray(array_.id());
  gl_->DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void BodyPass::set_material(const Material& material) const {
  if (scatters(material)) program_.set("diffuse", material.diffuse);
  program_.set("reflectance", material.reflectance);
  program_.set("roughness", material.roughness);
}

void BodyPass::set_studio(const Studio& studio) const {
  constexpr std::size_t count = Studio::light_count;
  std::array<glm::vec3, count> centre{};
  std::array<glm::vec3, count> across{};
  std::array<glm::vec3, count> along{};
  std::array<glm::vec3, count> radiance{};
  std::array<glm::vec2, count> half_size{};
  for (std::size_t i = 0; i < count; ++i) {
    const AreaLight& light = studio.lights[i];
    centre[i] = light.centre;
    half_size[i] = {glm::length(light.across), glm::length(light.along)};
    across[i] = light.across / half_size[i].x;
    along[i] = light.along / half_size[i].y;
    radiance[i] = light.radiance;
  }
  program_.set("light_centre", centre);
  program_.set("light_across", across);
  program_.set("light_along", along);
  program_.set("light_half_size", half_size);
  program_.set("light_radiance", radiance);
  program_.set("room_above", studio.above);
  program_.set("room_below", studio.below);
}

}  // namespace twrench
