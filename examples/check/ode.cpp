// A free body in the Open Dynamics Engine. The variant is gyroscopic, which is ODE's default,
// gyroscopic-finite, which adds finite rotations, or none.
#include <ode/ode.h>

#include <cstring>

#include "free_rotation.h"

int main(int argc, char** argv) {
  const Problem problem = read_problem(argc, argv);
  const bool is_finite = std::strcmp(problem.variant, "gyroscopic-finite") == 0;
  const bool is_gyroscopic = is_finite || std::strcmp(problem.variant, "gyroscopic") == 0;
  if (!is_gyroscopic && std::strcmp(problem.variant, "none") != 0) reject_variant(problem.variant);
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  const double* const I = problem.moments;
  dMassSetParameters(&mass, 1, 0, 0, 0, I[0], I[1], I[2], 0, 0, 0);
  dBodySetMass(body, &mass);
  dBodySetGyroscopicMode(body, is_gyroscopic ? 1 : 0);
  dBodySetFiniteRotationMode(body, is_finite ? 1 : 0);
  dBodySetAngularVel(body, problem.omega[0], problem.omega[1], problem.omega[2]);
  const auto write = [&](double t) {
    const dReal* const turned = dBodyGetQuaternion(body);
    const dReal* const w = dBodyGetAngularVel(body);  // in space axes
    const double q[4] = {turned[0], turned[1], turned[2], turned[3]};
    const double in_space[3] = {w[0], w[1], w[2]};
    write_row_from_space(t, q, in_space);
  };
  simulate(
      problem, [&] { dWorldStep(world, problem.step); }, write);
  dWorldDestroy(world);
  dCloseODE();
}
