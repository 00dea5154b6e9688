// An engineer designs a satellite: a bus, a hollow mast with a heavy tip, and a plate that is given
// as a mesh. About which axes may it spin, how soon does it turn over about the others, and which
// method simulates it well enough? The methods are named on the command line. Try: engineer rk4
// rkmk4 The textbook method rk4 is of second order on the group SO(3); its Munthe-Kaas form is of
// fourth. Units are m, kg and s: any consistent units work.
#include <twrench/twrench.h>

#include <array>
#include <cstdio>
#include <numbers>
#include <string>

using namespace twrench;

namespace {

/// A plate with its lower corner at the origin, as triangles with their outer side
/// counterclockwise.
body::TriangleMesh plate(const Eigen::Vector3d& size) {
  body::TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double x : {0.0, 1.0}) {
        mesh.vertices.push_back(size.cwiseProduct(Eigen::Vector3d(x, y, z)));
      }
    }
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace

int main(int argc, char** argv) try {
  const Eigen::Matrix3d along_x = body::frame_with_z_along({1, 0, 0});
  const std::array satellite{
      body::Part{body::Box{{0.4, 0.3, 0.5}}, 300, {0, 0, 0}},
      body::Part{body::Tube{0.02, 0.015, 1.2}, 2700, {0.8, 0, 0}, along_x},
      body::Part{body::Ellipsoid{{0.06, 0.06, 0.06}}, 4000, {1.4, 0, 0}},
      body::Part{body::make_mesh(plate({0.6, 0.9, 0.01})), 1500, {-0.3, 0.15, -0.1}},
  };
  const body::MassProperties properties = body::mass_properties(satellite);
  std::printf("mass %.17g kg\n", properties.mass);
  const body::PrincipalAxes principal = body::principal_axes(properties.inertia);
  for (const auto axis : body::PrincipalAxes::all) {
    const double spin = 2 * std::numbers::pi / 10;
    const motion::Stability tilt = motion::stability(principal.moments, axis, spin);
    const bool grows = tilt.kind == motion::Stability::Kind::unstable;
    std::printf("moment %.17g kg m^2, a tilt %s %.17g s\n", principal.moments[axis],
                grows ? "doubles in" : "wobbles with the period",
                grows ? tilt.doubling_time() : tilt.period());
  }

  const Eigen::Vector3d spin = principal.axes * Eigen::Vector3d(0, 0.6, 0.01);
  const motion::FreeBody body(properties.inertia, spin);
  const motion::ExactMotion exact(body);
  std::printf("turns over every %.17g s, at first at %.17g s\n", exact.flips()->interval,
              exact.flips()->first);

  study::StudyPlan plan;
  plan.steps = {0.1, 0.05, 0.025};
  plan.duration = 20;
  for (int i = 1; i < argc; ++i) plan.methods.push_back(&motion::find_method(argv[i]));
  for (const study::MethodStudy& result : study::run_study(body, plan).methods) {
    std::printf("%s has order %.2f\n", std::string(result.method->name).c_str(),
                result.order.value_or(0));
  }
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n%s\n", error.what(), error.remedy().c_str());
  return 1;
}
