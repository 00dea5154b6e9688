#include "scene/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

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

std::string course_of_tilt(const motion::Stability& stability, double omega, Language language) {
  using Kind = motion::Stability::Kind;
  const auto every = [&](const Phrase& phrase, double time) {
    const TimeUnit unit = time_unit(time);
    return phrase.in(language, time / unit.length, unit.symbol, omega);
  };
  switch (stability.kind) {
    case Kind::neutral:
      return "";
    case Kind::unstable:
      return every(
          {"doubles every {:.3g} {} at {:.3g} rad/s", "dobles på {:.3g} {} ved {:.3g} rad/s"},
          stability.doubling_time());
    case Kind::stable:
      return every(
          {"wobbles every {:.3g} {} at {:.3g} rad/s", "slingrer på {:.3g} {} ved {:.3g} rad/s"},
          stability.period());
  }
  return {};
}

std::string prediction(const body::PrincipalAxes& principal, body::PrincipalAxes::Axis axis,
                       double omega, Language language) {
  using Kind = motion::Stability::Kind;
  static constexpr std::array<std::pair<Kind, Phrase>, 3> kinds{
      {{Kind::neutral, {"neutral about {}", "nøytral om {}"}},
       {Kind::unstable, {"unstable about {}, {}", "ustabil om {}, {}"}},
       {Kind::stable, {"stable about {}, {}", "stabil om {}, {}"}}}};
  const motion::Stability stability = motion::stability(principal.moments, axis, omega);
  const auto kind = std::ranges::find(kinds, stability.kind, &std::pair<Kind, Phrase>::first);
  return kind->second.in(language, axis_name(principal.axes, axis),
                         course_of_tilt(stability, omega, language));
}

}  // namespace twrench::scene
