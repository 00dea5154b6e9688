#pragma once

#include <Eigen/Core>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "picture/body/body_model.h"
#include "picture/space/camera.h"

namespace twrench::picture {

/// Uniforms of all programs of a body in one pose.
struct StageUniforms {
  glm::vec3 eye;
  glm::mat4 clip_from_stage;
  glm::mat3 stage_from_body;
  glm::mat3 stage_normal_from_body;
};

/// Returns the uniforms for a body of that bounding radius in cm, in the pose X, space_from_body.
StageUniforms stage_uniforms(const Camera& camera, const Eigen::Matrix3d& X, double radius);

/// The same for the body's image in a horizontal mirror at y = `height` cm in space, below the
/// camera. The body keeps its lighting, and the camera sees a mirrored stage.
StageUniforms mirrored_stage_uniforms(const Camera& camera, const Eigen::Matrix3d& X, double radius,
                                      double height);

/// Returns the unit vector along the side of a part in stage coordinates; 0 if it has none.
glm::vec3 side_axis_in_stage(const BodyModel& body, const PartModel& part, const Camera& camera,
                             const Eigen::Matrix3d& X);

/// Uniform arrays that shade a part by the parts near it.
struct OccluderUniforms {
  std::vector<glm::vec4> from, to, tint;
};

/// Returns the uniforms of a part, with as many elements as the body's occluder_count. If `smooth`,
/// occluders that meet the part shade it smoothly.
OccluderUniforms occluder_uniforms(const BodyModel& body, const PartModel& part,
                                   const Camera& camera, const Eigen::Matrix3d& X, bool smooth);

}  // namespace twrench::picture
