#include "scene/prediction.h"

#include <fmt/format.h>

#include "base/enumeration.h"
#include "base/time_unit.h"

namespace twrench::scene {

std::string axis_name(const Eigen::Matrix3d& axes, int axis) {
  constexpr double along = 1 - 1e-9;
  Eigen::Index nearest = 0;
  const double most = axes.col(axis).cwiseAbs().maxCoeff(&nearest);
  if (most > along) return std::string(1, "xyz"[nearest]);
  return fmt::format("I{}", axis + 1);
}

std::string prediction(const body::PrincipalAxes& principal, body::PrincipalAxes::Axis axis,
                       double omega) {
  using Kind = motion::Stability::Kind;
  const motion::Stability stability = motion::stability(principal.moments, axis, omega);
  const std::string about =
      fmt::format("{} about {}", enumerator_name(stability.kind), axis_name(principal.axes, axis));
  if (stability.kind == Kind::neutral) return about;
  const bool grows = stability.kind == Kind::unstable;
  const double time = grows ? stability.doubling_time() : stability.period();
  const TimeUnit unit = time_unit(time);
  return fmt::format("{}, {} every {:.3g} {} at {:.3g} rad/s", about, grows ? "doubles" : "wobbles",
                     time / unit.length, unit.symbol, omega);
}

}  // namespace twrench::scene
