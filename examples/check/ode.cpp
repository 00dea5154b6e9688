// A free body in the Open Dynamics Engine: gyroscopic, which is the default; gyroscopic-finite,
// with finite rotations too; or none.
#include <ode/ode.h>

#include <cstring>

#include "free_rotation.h"

int main(int argc, char** argv) {
  const double h = step_size(argc, argv);
  const char* const variant = argc > 2 ? argv[2] : "gyroscopic";
  const bool is_finite = std::strcmp(variant, "gyroscopic-finite") == 0;
  const bool is_gyroscopic = is_finite || std::strcmp(variant, "gyroscopic") == 0;
  if (!is_gyroscopic && std::strcmp(variant, "none") != 0) {
    std::fprintf(stderr, "ODE has no variant %s\n", variant);
    return 3;
  }
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetParameters(&mass, 1, 0, 0, 0, moments[0], moments[1], moments[2], 0, 0, 0);
  dBodySetMass(body, &mass);
  dBodySetGyroscopicMode(body, is_gyroscopic ? 1 : 0);
  dBodySetFiniteRotationMode(body, is_finite ? 1 : 0);
  dBodySetAngularVel(body, start[0], start[1], start[2]);
  const auto write = [&](double t) {
    const dReal* const turned = dBodyGetQuaternion(body);
    const dReal* const w = dBodyGetAngularVel(body);  // in space axes
    const double q[4] = {turned[0], turned[1], turned[2], turned[3]};
    const double in_space[3] = {w[0], w[1], w[2]};
    double in_body[3];
    to_body(q, in_space, in_body);
    write_row(t, q, in_body);
  };
  simulate(
      h, [&] { dWorldStep(world, h); }, write);
  dWorldDestroy(world);
  dCloseODE();
}
