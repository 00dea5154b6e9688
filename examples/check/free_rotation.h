// What the programs beside it share: the body, its start, and the rows of CSV that `twrench check`
// reads. Nothing here is of twrench: what is judged must not come from the judge.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>

/// The T-wrench of `twrench inertia dzhanibekov`: principal moments about the body's x, y and z
/// axes in units of 1000 g cm^2.
constexpr double moments[3] = {0.9822713030224087, 0.7226710300807721, 1.578650308428871};

/// The angular velocity at t = 0 in body axes, rad/s. The body's axes are then those of space.
constexpr double start[3] = {1.0, 0.05, 0.0};

/// When a run ends, and how far apart its rows are, in s.
constexpr double duration = 96.0;
constexpr double row_interval = 0.1;

/// A row: the attitude as a quaternion w, x, y, z from body to space axes, and the angular velocity
/// in body axes, rad/s.
inline void write_row(double t, const double q[4], const double omega[3]) {
  std::printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", t, q[0], q[1], q[2], q[3],
              omega[0], omega[1], omega[2]);
}

/// The step size in s, from the command line.
inline double step_size(int argc, char** argv) {
  const double h = argc > 1 ? std::atof(argv[1]) : 0;
  if (h > 0 && h <= row_interval) return h;
  std::fprintf(stderr, "usage: %s STEP [VARIANT]: a step size in s that divides 0.1\n", argv[0]);
  std::exit(2);
}

/// Writes the header, and a row at t = 0 and every 0.1 s. `step` advances the simulation by h;
/// `write` writes its state at a time.
template <typename Step, typename Write>
void simulate(double h, Step&& step, Write&& write) {
  std::puts("t,qw,qx,qy,qz,wx,wy,wz");
  const int steps_per_row = static_cast<int>(std::lround(row_interval / h));
  const int rows = static_cast<int>(std::lround(duration / row_interval));
  for (int row = 0; row <= rows; ++row) {
    write(row * steps_per_row * h);
    for (int i = 0; i < steps_per_row; ++i) step();
  }
}

/// Turns a vector from space to body axes by the inverse of the quaternion q = w, x, y, z.
inline void to_body(const double q[4], const double v[3], double result[3]) {
  // v - 2 w (u x v) + 2 u x (u x v) with u = (x, y, z)
  const double c[3] = {q[2] * v[2] - q[3] * v[1], q[3] * v[0] - q[1] * v[2],
                       q[1] * v[1] - q[2] * v[0]};
  result[0] = v[0] + 2 * (-q[0] * c[0] + q[2] * c[2] - q[3] * c[1]);
  result[1] = v[1] + 2 * (-q[0] * c[1] + q[3] * c[0] - q[1] * c[2]);
  result[2] = v[2] + 2 * (-q[0] * c[2] + q[1] * c[1] - q[2] * c[0]);
}
