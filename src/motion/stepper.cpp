#include "motion/stepper.h"

#include <array>

#include "math/so3.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Stages = std::array<Vector3d, 6>;

/// sum of row[j] * s[j] over the first `count` stages.
Vector3d weighted_sum(const Tableau::Row& row, const Stages& s, int count) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) sum += row[j] * s[j];
  return sum;
}

Vector3d body_momentum(const FreeBody& body, Update update, const Matrix3d& X) {
  if (update == Update::linear) return X.inverse() * body.momentum;
  return X.transpose() * body.momentum;
}

/// The stage velocities: s_k = I^-1 exp(-h sum_j a_kj S_j) W^T L, sections 4.2 to 4.5.
Stages stage_velocities(const FreeBody& body, const Method& method, const Matrix3d& X, double h) {
  const Tableau& tableau = method.tableau;
  const Vector3d momentum = body_momentum(body, method.update, X);
  Stages s;
  s[0] = body.inverse * momentum;
  for (int k = 1; k < tableau.stages; ++k) {
    const auto row = static_cast<std::size_t>(k);
    const Vector3d u = h * weighted_sum(tableau.a[row], s, k);
    s[row] = body.inverse * (so3::exp(-u) * momentum);
  }
  return s;
}

}  // namespace

Vector3d angular_velocity(const FreeBody& body, Update update, const Matrix3d& X) {
  return body.inverse * body_momentum(body, update, X);
}

Step take_step(const FreeBody& body, const Method& method, const Matrix3d& X, double h) {
  const Tableau& tableau = method.tableau;
  const Stages s = stage_velocities(body, method, X, h);
  const Vector3d u = h * weighted_sum(tableau.weights, s, tableau.stages);
  if (method.update == Update::linear) return {X + X * so3::hat(u), 0.0};
  const Matrix3d rotation = so3::exp(u);
  if (!method.adaptive()) return {X * rotation, 0.0};
  // |W' - Z'| = |W (exp u - exp v)| = |exp u - exp v|, because W is orthogonal.
  const Vector3d v = h * weighted_sum(tableau.embedded, s, tableau.stages);
  return {X * rotation, (rotation - so3::exp(v)).norm()};
}

}  // namespace twrench
