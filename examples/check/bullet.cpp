// A free body in Bullet, with the gyroscopic torque that is named: none, explicit, implicit-world,
// implicit-body, which is the default.
#include <btBulletDynamicsCommon.h>

#include <cstring>

#include "free_rotation.h"

int gyroscopic_flags(const char* name) {
  if (std::strcmp(name, "none") == 0) return 0;
  if (std::strcmp(name, "explicit") == 0) return BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
  if (std::strcmp(name, "implicit-world") == 0) return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD;
  if (std::strcmp(name, "implicit-body") == 0) return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
  std::fprintf(stderr, "Bullet has no gyroscopic torque %s\n", name);
  std::exit(3);
}

int main(int argc, char** argv) {
  const double h = step_size(argc, argv);
  const int flags = gyroscopic_flags(argc > 2 ? argv[2] : "implicit-body");
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, 0));
  btSphereShape shape(1);
  btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(
      1, nullptr, &shape,
      btVector3(btScalar(moments[0]), btScalar(moments[1]), btScalar(moments[2]))));
  body.setFlags(flags);
  body.setActivationState(DISABLE_DEACTIVATION);
  body.setAngularVelocity(btVector3(btScalar(start[0]), btScalar(start[1]), btScalar(start[2])));
  world.addRigidBody(&body);
  const auto write = [&](double t) {
    const btQuaternion turned = body.getOrientation();
    const btVector3& w = body.getAngularVelocity();  // in space axes
    const double q[4] = {turned.w(), turned.x(), turned.y(), turned.z()};
    const double in_space[3] = {w.x(), w.y(), w.z()};
    double in_body[3];
    to_body(q, in_space, in_body);
    write_row(t, q, in_body);
  };
  simulate(
      h, [&] { world.stepSimulation(btScalar(h), 0); }, write);
  world.removeRigidBody(&body);
}
