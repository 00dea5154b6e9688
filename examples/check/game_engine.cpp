// The integrator of a game engine that includes the gyroscopic torque: the angular velocity is
// advanced in space axes by the torque -omega x (I omega) at the old orientation, the orientation
// by the new angular velocity (semi-implicit Euler), and the quaternion is normalised.
#include <array>

#include "free_rotation.h"

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector body_from_space(const double q[4], const Vector& v) {
  Vector result{};
  to_body(q, v.data(), result.data());
  return result;
}

Vector space_from_body(const double q[4], const Vector& v) {
  const double inverse[4] = {q[0], -q[1], -q[2], -q[3]};
  return body_from_space(inverse, v);
}

int main(int argc, char** argv) {
  const Problem problem = read_problem(argc, argv);
  const double* const I = problem.moments;
  const double h = problem.step;
  Vector w = {problem.omega[0], problem.omega[1], problem.omega[2]};  // in space axes
  double q[4] = {1, 0, 0, 0};
  const auto step = [&] {
    const Vector local = body_from_space(q, w);
    const Vector momentum = {I[0] * local[0], I[1] * local[1], I[2] * local[2]};
    const Vector torque = cross(momentum, local);  // -omega x (I omega)
    const Vector change =
        space_from_body(q, {torque[0] / I[0], torque[1] / I[1], torque[2] / I[2]});
    for (std::size_t i = 0; i < 3; ++i) w[i] += h * change[i];
    // q' = (0, omega) q / 2 with omega in space axes
    const double rate[4] = {
        -w[0] * q[1] - w[1] * q[2] - w[2] * q[3], w[0] * q[0] + w[1] * q[3] - w[2] * q[2],
        w[1] * q[0] + w[2] * q[1] - w[0] * q[3], w[2] * q[0] + w[0] * q[2] - w[1] * q[1]};
    double square = 0;
    for (int i = 0; i < 4; ++i) {
      q[i] += h / 2 * rate[i];
      square += q[i] * q[i];
    }
    for (double& component : q) component /= std::sqrt(square);
  };
  simulate(problem, step, [&](double t) { write_row_from_space(t, q, w.data()); });
}
