// Shared by the C++ programs in this folder: the command line, and the rows of CSV that `twrench
// check` reads. It does not use twrench, because the programs under test must not depend on the
// judge.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>

/// The command line: STEP A,B,C X,Y,Z DURATION [VARIANT].
struct Problem {
  double step;          ///< s
  double moments[3];    ///< principal moments about the body's x, y and z axes
  double omega[3];      ///< angular velocity at t = 0, rad/s; body and space axes then coincide
  double duration;      ///< s
  const char* variant;  ///< the engine's integrator or option; "" if not given
};

constexpr double row_interval = 0.1;  // s

inline Problem read_problem(int argc, char** argv) {
  Problem p{};
  const bool is_complete =
      argc >= 5 && std::sscanf(argv[1], "%lf", &p.step) == 1 &&
      std::sscanf(argv[2], "%lf,%lf,%lf", &p.moments[0], &p.moments[1], &p.moments[2]) == 3 &&
      std::sscanf(argv[3], "%lf,%lf,%lf", &p.omega[0], &p.omega[1], &p.omega[2]) == 3 &&
      std::sscanf(argv[4], "%lf", &p.duration) == 1;
  if (is_complete && p.step > 0 && p.step <= row_interval) {
    p.variant = argc > 5 ? argv[5] : "";
    return p;
  }
  std::fprintf(stderr, "usage: %s STEP A,B,C X,Y,Z DURATION [VARIANT]; STEP divides 0.1\n",
               argv[0]);
  std::exit(2);
}

/// Ends a program that does not know the variant.
[[noreturn]] inline void reject_variant(const char* variant) {
  std::fprintf(stderr, "there is no variant '%s'\n", variant);
  std::exit(3);
}

/// Writes the attitude as a quaternion w, x, y, z from body to space axes, and the angular velocity
/// in body axes, rad/s.
inline void write_row(double t, const double q[4], const double omega[3]) {
  std::printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", t, q[0], q[1], q[2], q[3],
              omega[0], omega[1], omega[2]);
}

/// Writes the header, and a row at t = 0 and every 0.1 s. `step` advances the simulation by
/// `problem.step`; `write` writes its state at a time.
template <typename Step, typename Write>
void simulate(const Problem& problem, Step&& step, Write&& write) {
  std::puts("t,qw,qx,qy,qz,wx,wy,wz");
  const int steps_per_row = static_cast<int>(std::lround(row_interval / problem.step));
  const int rows = static_cast<int>(std::lround(problem.duration / row_interval));
  for (int row = 0; row <= rows; ++row) {
    write(row * steps_per_row * problem.step);
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

/// The same as write_row, with the angular velocity in space axes.
inline void write_row_from_space(double t, const double q[4], const double omega[3]) {
  double in_body[3];
  to_body(q, omega, in_body);
  write_row(t, q, in_body);
}
