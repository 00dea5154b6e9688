// A student's program. Euler's equations are solved by the Runge-Kutta method of order four, and
// the rates are excellent. The orientation comes afterwards, "since the rates are known": one step
// of Euler's method per time step, and a normalisation that keeps the quaternion a quaternion. That
// is the usual mistake: the orientation is of first order, whatever the order of the rates.
#include <array>

#include "free_rotation.h"

using Vector = std::array<double, 3>;

/// Euler's equations: I omega' = (I omega) x omega.
Vector derivative(const double I[3], const Vector& w) {
  return {(I[1] - I[2]) / I[0] * w[1] * w[2], (I[2] - I[0]) / I[1] * w[2] * w[0],
          (I[0] - I[1]) / I[2] * w[0] * w[1]};
}

Vector sum(const Vector& a, double factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Vector rk4(const double I[3], const Vector& w, double h) {
  const Vector k1 = derivative(I, w);
  const Vector k2 = derivative(I, sum(w, h / 2, k1));
  const Vector k3 = derivative(I, sum(w, h / 2, k2));
  const Vector k4 = derivative(I, sum(w, h, k3));
  return sum(sum(sum(sum(w, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

int main(int argc, char** argv) {
  const Problem problem = read_problem(argc, argv);
  const double h = problem.step;
  Vector w = {problem.omega[0], problem.omega[1], problem.omega[2]};
  double q[4] = {1, 0, 0, 0};
  const auto step = [&] {
    w = rk4(problem.moments, w, h);
    // q' = q (0, omega) / 2
    const double change[4] = {
        -q[1] * w[0] - q[2] * w[1] - q[3] * w[2], q[0] * w[0] + q[2] * w[2] - q[3] * w[1],
        q[0] * w[1] + q[3] * w[0] - q[1] * w[2], q[0] * w[2] + q[1] * w[1] - q[2] * w[0]};
    double square = 0;
    for (int i = 0; i < 4; ++i) {
      q[i] += h / 2 * change[i];
      square += q[i] * q[i];
    }
    for (double& component : q) component /= std::sqrt(square);
  };
  simulate(problem, step, [&](double t) { write_row(t, q, w.data()); });
}
