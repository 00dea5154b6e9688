#pragma once

#include <Eigen/Core>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace twrench::picture {

/// The one place where the doubles of the physics become the floats of the renderer. Both Eigen and
/// GLM store matrices by columns, for column vectors.
inline glm::vec3 glm_from_eigen(const Eigen::Vector3d& v) {
  const Eigen::Vector3f f = v.cast<float>();
  return {f.x(), f.y(), f.z()};
}

inline glm::mat3 glm_from_eigen(const Eigen::Matrix3d& m) {
  return {glm_from_eigen(m.col(0).eval()), glm_from_eigen(m.col(1).eval()),
          glm_from_eigen(m.col(2).eval())};
}

inline glm::mat4 glm_from_eigen(const Eigen::Matrix4d& m) {
  const Eigen::Matrix4f f = m.cast<float>();
  glm::mat4 result;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) result[column][row] = f(row, column);
  }
  return result;
}

}  // namespace twrench::picture
