#include "picture/body/body_uniforms.h"

#include <Eigen/Geometry>

#include "picture/space/glm_from_eigen.h"

namespace twrench::picture {
namespace {

using Eigen::Affine3d;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

/// Returns the matrix that transforms normals with the surface: the cofactor matrix. For a rotation
/// it is the rotation itself; it is also correct for a pose that has left SO(3).
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

Matrix3d stage_from_body(const Camera& camera, const Matrix3d& X, double radius) {
  return camera.camera_from_space() * X / radius;
}

/// The camera sees the stage transformed by `seen_from_stage`, which is its own inverse.
StageUniforms uniforms(const Camera& camera, const Matrix3d& X, double radius,
                       const Affine3d& seen_from_stage) {
  const Vector3d eye = seen_from_stage * Vector3d(0, 0, camera.distance / radius);
  const Matrix4d clip_from_stage =
      camera.projection * camera_from_stage(camera, radius) * seen_from_stage.matrix();
  const Matrix3d turn = normal_matrix(camera.camera_from_space() * X);
  return {glm_from_eigen(eye), glm_from_eigen(clip_from_stage),
          glm_from_eigen(stage_from_body(camera, X, radius)), glm_from_eigen(turn)};
}

}  // namespace

StageUniforms stage_uniforms(const Camera& camera, const Matrix3d& X, double radius) {
  return uniforms(camera, X, radius, Affine3d::Identity());
}

StageUniforms mirrored_stage_uniforms(const Camera& camera, const Matrix3d& X, double radius,
                                      double height) {
  Affine3d mirror = Affine3d::Identity();  // in space, in stage units
  mirror(1, 1) = -1;
  mirror(1, 3) = 2 * height / radius;
  const Affine3d stage_from_space(camera.camera_from_space());
  return uniforms(camera, X, radius, stage_from_space * mirror * stage_from_space.inverse());
}

glm::vec3 side_axis_in_stage(const BodyModel& body, const PartModel& part, const Camera& camera,
                             const Matrix3d& X) {
  const Matrix3d turned = body.radius * stage_from_body(camera, X, body.radius);
  return glm_from_eigen((turned * part.side_axis).eval());
}

OccluderUniforms occluder_uniforms(const BodyModel& body, const PartModel& part,
                                   const Camera& camera, const Matrix3d& X, bool smooth) {
  const std::size_t count = body.occluder_count;
  // Unused occluder slots: too small and far away to be visible.
  OccluderUniforms result{std::vector(count, glm::vec4(0, 0, -1e4F, 1e-6F)),
                          std::vector(count, glm::vec4(0, 1, -1e4F, 0)),
                          std::vector(count, glm::vec4(1))};
  const Matrix3d turned = stage_from_body(camera, X, body.radius);
  const auto end = [&](const Vector3d& place) { return glm_from_eigen((turned * place).eval()); };
  for (std::size_t i = 0; i < part.occluders.size(); ++i) {
    const Capsule& capsule = part.occluders[i];
    result.from[i] = glm::vec4(end(capsule.from), capsule.radius / body.radius);
    result.to[i] = glm::vec4(end(capsule.to), smooth && capsule.meets ? 1 : 0);
    result.tint[i] = glm::vec4(body.tints[capsule.part], 1);
  }
  return result;
}

}  // namespace twrench::picture
