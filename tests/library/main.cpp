// Uses the installed library as a program of somebody else's would: the flip of a body by a
// Runge-Kutta-Munthe-Kaas method, compared with the exact motion.
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>
#include <twrench/study/study.h>

#include <array>
#include <cstdio>

int main() {
  using namespace twrench;
  const Eigen::Matrix3d inertia = Eigen::Vector3d(1, 2, 3).asDiagonal();
  const motion::FreeBody body(inertia, {0.01, 1, 0});
  const std::array times{0.0, 10.0, 20.0};
  const motion::Trajectory trajectory =
      motion::integrate(body, motion::find_method("rkmk45"), {}, times);
  const motion::ExactMotion exact(body);
  const Eigen::Matrix3d& X = trajectory.samples.back().X;
  const double error = (X - exact.at(times.back()).X).norm();
  const double group = (so3::exp(so3::log(X)) - X).norm();
  std::printf("error %.1e, log and exp %.1e, flips every %.6f s\n", error, group,
              exact.flips()->interval);
  const study::Study study =
      study::run_study(body, {{&motion::find_method("rkmk4")}, {0.1, 0.05, 0.025}, {}, 0.01, 10});
  std::printf("order %.2f\n", study.methods.front().order.value_or(0));
  try {
    const motion::FreeBody impossible(Eigen::Vector3d(1, 2, -3).asDiagonal().toDenseMatrix(),
                                      {1, 0, 0});
    return 1;
  } catch (const InvalidArgument& refused) {
    std::printf("%s\n", refused.what());
  }
  return error < 1e-6 && group < 1e-12 ? 0 : 1;
}
