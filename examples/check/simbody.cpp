// A free body in Simbody, with steps of fixed size. The variant is the integrator:
// semi-explicit-euler, verlet or runge-kutta-merson.
#include <Simbody.h>

#include <cstring>
#include <memory>

#include "free_rotation.h"

std::unique_ptr<SimTK::Integrator> integrator_named(const char* name,
                                                    const SimTK::MultibodySystem& system,
                                                    double step) {
  if (std::strcmp(name, "semi-explicit-euler") == 0)
    return std::make_unique<SimTK::SemiExplicitEulerIntegrator>(system, step);
  std::unique_ptr<SimTK::Integrator> result;
  if (std::strcmp(name, "verlet") == 0)
    result = std::make_unique<SimTK::VerletIntegrator>(system);
  else if (std::strcmp(name, "runge-kutta-merson") == 0)
    result = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
  else
    reject_variant(name);
  result->setFixedStepSize(step);
  return result;
}

int main(int argc, char** argv) {
  const Problem problem = read_problem(argc, argv);
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  const double* const I = problem.moments;
  const SimTK::MassProperties mass(1, SimTK::Vec3(0), SimTK::Inertia(I[0], I[1], I[2]));
  SimTK::MobilizedBody::Free body(matter.Ground(), SimTK::Body::Rigid(mass));
  SimTK::State start = system.realizeTopology();
  body.setUToFitAngularVelocity(start, SimTK::Vec3::getAs(problem.omega));
  const auto integrator = integrator_named(problem.variant, system, problem.step);
  SimTK::TimeStepper stepper(system, *integrator);
  stepper.initialize(start);
  double time = 0;
  const auto step = [&] { stepper.stepTo(time += problem.step); };
  simulate(problem, step, [&](double t) {
    const SimTK::State& state = stepper.getState();
    system.realize(state, SimTK::Stage::Velocity);
    const SimTK::Quaternion q = body.getBodyRotation(state).convertRotationToQuaternion();
    write_row_from_space(t, &q[0], &body.getBodyAngularVelocity(state)[0]);
  });
}
