// A free body in DART, whose only integrator is semi-implicit Euler.
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>

#include "free_rotation.h"

int main(int argc, char** argv) {
  const Problem problem = read_problem(argc, argv);
  const auto world = dart::simulation::World::create();
  world->setGravity(Eigen::Vector3d::Zero());
  world->setTimeStep(problem.step);
  const auto skeleton = dart::dynamics::Skeleton::create();
  const auto [joint, body] = skeleton->createJointAndBodyNodePair<dart::dynamics::FreeJoint>();
  const double* const I = problem.moments;
  body->setInertia(dart::dynamics::Inertia(1, Eigen::Vector3d::Zero(),
                                           Eigen::Vector3d(I[0], I[1], I[2]).asDiagonal()));
  joint->setAngularVelocity(Eigen::Map<const Eigen::Vector3d>(problem.omega));
  world->addSkeleton(skeleton);
  const auto write = [&, body = body](double t) {
    const Eigen::Quaterniond turned(body->getWorldTransform().linear());
    const double q[4] = {turned.w(), turned.x(), turned.y(), turned.z()};
    write_row_from_space(t, q, body->getAngularVelocity().data());
  };
  simulate(
      problem, [&] { world->step(); }, write);
}
