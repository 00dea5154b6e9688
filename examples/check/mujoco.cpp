// A free body in MuJoCo, by the integrator that is named: Euler, RK4, implicit, implicitfast.
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
  std::fprintf(stderr, "MuJoCo %s has no integrator %s\n", mj_versionString(), name);
  std::exit(3);
}

int main(int argc, char** argv) {
  const double h = step_size(argc, argv);
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s STEP INTEGRATOR MODEL.xml\n", argv[0]);
    return 2;
  }
  char error[1000] = "";
  mjModel* const model = mj_loadXML(argv[3], nullptr, error, sizeof error);
  if (model == nullptr) {
    std::fprintf(stderr, "%s: %s\n", argv[3], error);
    return 1;
  }
  model->opt.timestep = h;
  model->opt.integrator = integrator_named(argv[2]);
  for (int i = 0; i < 3; ++i) model->body_inertia[3 + i] = moments[i];
  mjData* const data = mj_makeData(model);
  mj_setConst(model, data);  // what MuJoCo derives from the moments
  // A free joint has its position and quaternion in qpos, and its velocity in space and angular
  // velocity in body axes in qvel.
  for (int i = 0; i < 3; ++i) data->qvel[3 + i] = start[i];
  simulate(
      h, [&] { mj_step(model, data); },
      [&](double t) { write_row(t, data->qpos + 3, data->qvel + 3); });
  mj_deleteData(data);
  mj_deleteModel(model);
}
