// A free body in MuJoCo. The variant is the integrator: Euler, RK4, implicit or implicitfast. The
// model file, free_body.xml, is the last argument.
#include <mujoco/mujoco.h>

#include <cstring>

#include "free_rotation.h"

mjtIntegrator integrator_named(const char* name) {
  if (std::strcmp(name, "Euler") == 0) return mjINT_EULER;
  if (std::strcmp(name, "RK4") == 0) return mjINT_RK4;
  if (std::strcmp(name, "implicit") == 0) return mjINT_IMPLICIT;
#if mjVERSION_HEADER >= 233
  if (std::strcmp(name, "implicitfast") == 0) return mjINT_IMPLICITFAST;
#endif
  reject_variant(name);
}

int main(int argc, char** argv) {
  const Problem problem = read_problem(argc, argv);
  char error[1000] = "";
  mjModel* const model = mj_loadXML(argv[argc - 1], nullptr, error, sizeof error);
  if (model == nullptr) {
    std::fprintf(stderr, "%s: %s\n", argv[argc - 1], error);
    return 1;
  }
  model->opt.timestep = problem.step;
  model->opt.integrator = integrator_named(problem.variant);
  for (int i = 0; i < 3; ++i) model->body_inertia[3 + i] = problem.moments[i];
  mjData* const data = mj_makeData(model);
  mj_setConst(model, data);  // values that MuJoCo derives from the moments
  // qpos is the position and the quaternion of the free joint; qvel is its velocity in space axes
  // and its angular velocity in body axes.
  for (int i = 0; i < 3; ++i) data->qvel[3 + i] = problem.omega[i];
  simulate(
      problem, [&] { mj_step(model, data); },
      [&](double t) { write_row(t, data->qpos + 3, data->qvel + 3); });
  mj_deleteData(data);
  mj_deleteModel(model);
}
