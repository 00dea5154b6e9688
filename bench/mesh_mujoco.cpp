// mesh_mujoco MODEL.xml: prints the mass, then the principal moments of the first body of a MuJoCo
// model.
#include <mujoco/mujoco.h>

#include <cstdio>

int main(int argc, char** argv) {
  char error[1000] = "";
  mjModel* const model = argc == 2 ? mj_loadXML(argv[1], nullptr, error, sizeof error) : nullptr;
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    return 1;
  }
  const mjtNum* const moments = model->body_inertia + 3;  // The first body is the world.
  std::printf("%.17g %.17g %.17g %.17g\n", model->body_mass[1], moments[0], moments[1], moments[2]);
  mj_deleteModel(model);
}
