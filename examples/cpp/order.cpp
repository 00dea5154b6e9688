// Is the order of a method on SO(3) what its coefficients promise? Builds a T-wrench from two
// cylinders, runs the methods named on the command line with smaller and smaller steps, and fits
// the order to their errors against the exact motion. The textbook method rk4 turns out to be of
// second order on the group; its Munthe-Kaas form is of fourth. Try: order rk4 rkmk4 suzuki4
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/study/study.h>

#include <array>
#include <cstdio>
#include <string>

using namespace twrench;

int main(int argc, char** argv) try {
  // Radius and length in cm, density in g/cm^3, position in cm, and where the axis points.
  const body::Part bar{body::Cylinder{1, 8}, 6.7, {-1, 0, 0}, body::frame_with_z_along({0, 1, 0})};
  const body::Part leg{body::Cylinder{1, 4}, 6.7, {2, 0, 0}, body::frame_with_z_along({1, 0, 0})};
  const body::MassProperties wrench = body::mass_properties(std::array{bar, leg});
  std::printf("mass %.3f g, principal moments %.3f, %.3f and %.3f g cm^2\n", wrench.mass,
              wrench.moments[0], wrench.moments[1], wrench.moments[2]);

  study::StudyPlan plan;
  plan.steps = {0.1, 0.05, 0.025};
  plan.duration = 20;
  for (int i = 1; i < argc; ++i) plan.methods.push_back(&motion::find_method(argv[i]));
  const motion::FreeBody free_body(wrench.inertia, {1, 0.05, 0});
  for (const study::MethodStudy& result : study::run_study(free_body, plan).methods) {
    std::printf("%-20s order %.2f, error %.1e after 20 s with the smallest step\n",
                std::string(result.method->name).c_str(), result.order.value_or(0),
                result.runs.back().error);
  }
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n%s\n", error.what(), error.remedy().c_str());
  return 1;
}
