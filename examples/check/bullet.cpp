// A free body in Bullet. The variant is the gyroscopic torque: none, explicit, implicit-world or
// implicit-body, which is Bullet's default.
#include <btBulletDynamicsCommon.h>

#include <cstring>

#include "free_rotation.h"

int gyroscopic_flags(const char* name) {
  if (std::strcmp(name, "none") == 0) return 0;
  if (std::strcmp(name, "explicit") == 0) return BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
  if (std::strcmp(name, "implicit-world") == 0) return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD;
  if (std::strcmp(name, "implicit-body") == 0) return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
  reject_variant(name);
}

int main(int argc, char** argv) {
  const Problem problem = read_problem(argc, argv);
  const auto vector = [](const double v[3]) {
    return btVector3(btScalar(v[0]), btScalar(v[1]), btScalar(v[2]));
  };
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, 0));
  btSphereShape shape(1);
  btRigidBody body(1, nullptr, &shape, vector(problem.moments));
  body.setFlags(gyroscopic_flags(problem.variant));
  body.setActivationState(DISABLE_DEACTIVATION);
  body.setAngularVelocity(vector(problem.omega));
  world.addRigidBody(&body);
  const auto write = [&](double t) {
    const btQuaternion turned = body.getOrientation();
    const btVector3& w = body.getAngularVelocity();  // in space axes
    const double q[4] = {turned.w(), turned.x(), turned.y(), turned.z()};
    const double in_space[3] = {w.x(), w.y(), w.z()};
    write_row_from_space(t, q, in_space);
  };
  simulate(
      problem, [&] { world.stepSimulation(btScalar(problem.step), 0); }, write);
  world.removeRigidBody(&body);
}
