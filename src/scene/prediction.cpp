#include "scene/prediction.h"

#include <fmt/format.h>

#include <array>

#include "base/time_unit.h"
#include "scene/phrase.h"

namespace twrench::scene {

std::string axis_name(const Eigen::Matrix3d& axes, int axis) {
  const Eigen::Vector3d named = named_axis(axes, axis);
  for (const int k : {0, 1, 2}) {
    if (named == Eigen::Vector3d::Unit(k)) return std::string(1, "xyz"[k]);
  }
  return fmt::format("I{}", axis + 1);
}

Eigen::Vector3d named_axis(const Eigen::Matrix3d& axes, int axis) {
  constexpr double along = 1 - 1e-9;
  Eigen::Index nearest = 0;
  const double most = axes.col(axis).cwiseAbs().maxCoeff(&nearest);
  if (most > along) return Eigen::Vector3d::Unit(nearest);
  return axes.col(axis);
}

std::string rank_name(std::size_t rank, Language language) {
  static constexpr std::array<Phrase, 3> names{
      {{"least", "minste"}, {"middle", "midterste"}, {"greatest", "største"}}};
  return names.at(rank).in(language);
}

std::string prediction(const body::PrincipalAxes& principal, body::PrincipalAxes::Axis axis,
                       double omega, Language language) {
  using Kind = motion::Stability::Kind;
  const motion::Stability stability = motion::stability(principal.moments, axis, omega);
  const std::string name = axis_name(principal.axes, axis);
  const auto every = [&](const Phrase& phrase, double time) {
    const TimeUnit unit = time_unit(time);
    return phrase.in(language, name, time / unit.length, unit.symbol, omega);
  };
  switch (stability.kind) {
    case Kind::neutral:
      return Phrase("neutral about {}", "nøytral om {}").in(language, name);
    case Kind::unstable:
      return every({"unstable about {}, doubles every {:.3g} {} at {:.3g} rad/s",
                    "ustabil om {}, dobles på {:.3g} {} ved {:.3g} rad/s"},
                   stability.doubling_time());
    case Kind::stable:
      return every({"stable about {}, wobbles every {:.3g} {} at {:.3g} rad/s",
                    "stabil om {}, slingrer på {:.3g} {} ved {:.3g} rad/s"},
                   stability.period());
  }
  return {};
}

}  // namespace twrench::scene
