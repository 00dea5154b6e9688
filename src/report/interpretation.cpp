#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/math/so3.h>
#include <twrench/motion/stability.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "math/elliptic.h"
#include "report/motion_parts.h"
#include "report/tables.h"
#include "scene/prediction.h"

namespace twrench::report {
namespace {

constexpr double in_degrees = 180 / std::numbers::pi;
constexpr std::array<std::string_view, 3> subscripts{"₁", "₂", "₃"};

std::string short_number(double value) {
  return (value < 0 ? "−" : "") + fmt::format("{:.3g}", std::abs(value));
}

/// How far a principal axis goes from its initial direction.
struct Excursion {
  /// "x₁₁" if the body axis x is the axis and lies along the space axis; otherwise words.
  std::string component;
  /// Smallest value of that component, the cosine of the largest angle from the initial direction.
  double least_cosine = 1;
  /// How far it goes across that direction: "x₂₁ and x₃₁ reach 0.99 and 0.9 in magnitude".
  std::string perpendicular;
};

Excursion excursion(const Solution& solution, body::PrincipalAxes::Axis principal_axis) {
  const Language language = solution.scene().language;
  const Eigen::Matrix3d& axes = solution.body.principal().axes;
  const std::string name = scene::axis_name(axes, principal_axis);
  const std::size_t k = std::string_view("xyz").find(name);
  const Eigen::Vector3d axis = scene::named_axis(axes, principal_axis);
  const Eigen::Vector3d initial = solution.reference.front().X * axis;
  Excursion result;
  double largest_sine = 0;  // Largest length of the part perpendicular to the initial direction.
  Eigen::Vector3d largest = Eigen::Vector3d::Zero();
  for (const motion::Sample& sample : solution.reference) {
    const Eigen::Vector3d now = sample.X * axis;
    const double cosine = now.dot(initial);
    const Eigen::Vector3d across = now - cosine * initial;
    result.least_cosine = std::min(result.least_cosine, cosine);
    largest_sine = std::max(largest_sine, across.norm());
    largest = largest.cwiseMax(across.cwiseAbs());
  }
  if (k == std::string_view::npos || initial != axis) {
    result.component = Phrase("The component of the principal axis {} along its initial direction",
                              "Komponenten av hovedaksen {} langs retningen den startet i")
                           .in(language, name);
    result.perpendicular = Phrase("The part of this axis across that direction reaches {}",
                                  "Delen av aksen på tvers av den retningen kommer opp i {}")
                               .in(language, short_number(largest_sine));
    return result;
  }
  const std::size_t i = k == 0 ? 1 : 0, j = k == 2 ? 1 : 2;
  result.component = fmt::format("x{0}{0}", subscripts[k]);
  result.perpendicular = Phrase("x{0}{2} and x{1}{2} reach {3} and {4} in magnitude",
                                "Absoluttverdiene av x{0}{2} og x{1}{2} kommer opp i {3} og {4}")
                             .in(language, subscripts[i], subscripts[j], subscripts[k],
                                 short_number(largest[static_cast<int>(i)]),
                                 short_number(largest[static_cast<int>(j)]));
  return result;
}

/// After two sign changes omega repeats; X has then turned about L.
std::string repetition(const Solution& solution, const motion::ExactMotion::Flips& flips) {
  const double period = 2 * flips.interval;
  return Phrase(
             "ω repeats after {} s, 4K(m)/λ. X does not: in that time it turns about L by {} "
             "degrees, apart from whole turns.",
             "ω gjentar seg etter {} s, 4K(m)/λ. Det gjør ikke X: I løpet av den tiden dreier X "
             "{} grader om L, i tillegg til hele omdreininger.")
      .in(solution.scene().language, digits(period),
          short_number(so3::log(solution.exact->at(period).X).norm() * in_degrees));
}

std::string spin_period(const Solution& solution) {
  return short_number(2 * std::numbers::pi / solution.body.omega().norm());
}

/// The time between flips, for a rotation that begins near the intermediate axis.
std::string waiting(const Solution& solution, const motion::ExactMotion::Flips& flips) {
  const motion::Tilt tilt(solution.body);
  if (tilt.axis() != body::PrincipalAxes::intermediate) return {};
  const motion::Stability unstable =
      motion::stability(solution.body.principal().moments, tilt.axis(), tilt.steady_rate());
  // sn = 0.9.
  const double crossing =
      2 * elliptic::incomplete_first(0.9, std::sqrt(1 - 0.81), flips.mc) / flips.rate;
  return Phrase(
             "ω₂ crosses from 90 % of its largest value to −90 % in {} s of the {} s between "
             "flips. "
             "For the rest the body turns almost steadily about the intermediate axis, because a "
             "small tilt grows only as exp(rt), r = {} 1/s. Meanwhile the components of the other "
             "two axes oscillate with about the period of the spin, 2π/|ω| = {} s. ",
             "ω₂ går fra 90 % av sin største verdi til −90 % på {} s av de {} s mellom vendingene. "
             "Resten av tiden roterer legemet nesten jevnt om den midterste aksen, fordi en liten "
             "helling bare vokser som exp(rt), r = {} 1/s. Imens svinger komponentene av de to "
             "andre aksene med omtrent samme periode som rotasjonen, 2π/|ω| = {} s. ")
      .in(solution.scene().language, short_number(crossing), short_number(flips.interval),
          short_number(unstable.rate), spin_period(solution));
}

std::string turning_over(const Solution& solution, const motion::ExactMotion::Flips& flips) {
  const Excursion far = excursion(solution, body::PrincipalAxes::intermediate);
  const Language language = solution.scene().language;
  std::vector<double> times = solution.own.flip_times;
  const bool all = times.size() <= 6;
  times.resize(std::min<std::size_t>(times.size(), 6));
  if (times.empty()) {
    return Phrase("The body turns over, but not yet in this time: the first flip is at {} s. ",
                  "Legemet snur, men ikke ennå i løpet av denne tiden: Den første vendingen er ved "
                  "{} s. ")
               .in(language, short_number(flips.first)) +
           waiting(solution, flips) + repetition(solution, flips);
  }
  return Phrase(
             "{} starts at 1 and falls to {}: the body turns over. Its intermediate axis swings "
             "through {} degrees, from one side of the plane normal to L to the other, and the "
             "body goes on spinning in the same sense in space. {}. The body flips, as ω₂ changes "
             "sign, at {:.4g}{} s. ",
             "{} starter på 1 og synker til {}: Legemet snur. Den midterste aksen svinger {} "
             "grader, fra den ene siden av planet normalt på L til den andre, og legemet "
             "fortsetter "
             "å spinne samme vei i rommet. {}. Legemet vender ved {:.4g}{} s, idet ω₂ skifter "
             "fortegn. ")
             .in(language, far.component, short_number(far.least_cosine),
                 short_number(flips.swing * in_degrees), far.perpendicular, fmt::join(times, ", "),
                 all ? "" : ", …") +
         waiting(solution, flips) + repetition(solution, flips);
}

std::string wobbling(const Solution& solution, const motion::ExactMotion::Flips& flips) {
  const body::PrincipalAxes& principal = solution.body.principal();
  const bool least = solution.exact->kind() == motion::ExactMotion::Kind::about_least;
  const auto axis = least ? body::PrincipalAxes::least : body::PrincipalAxes::greatest;
  const Language language = solution.scene().language;
  const Excursion far = excursion(solution, axis);
  const motion::Stability stable = motion::stability(
      principal.moments, axis, solution.body.momentum().norm() / principal.moments[axis]);
  return Phrase(
             "{} stays above {:.3f}: the axis of {} moment stays within {} degrees of its initial "
             "direction. {}. The body wobbles and does not turn over. The components of the other "
             "two axes oscillate with about the period of the spin, 2π/|ω| = {} s, and the wobble "
             "has the period 4K(m)/λ = {} s, {} s in the limit of a small tilt. ",
             "{} holder seg over {:.3f}: Aksen med {} treghetsmoment holder seg innenfor {} grader "
             "fra retningen den startet i. {}. Legemet slingrer og snur ikke. Komponentene av de "
             "to "
             "andre aksene svinger med omtrent samme periode som rotasjonen, 2π/|ω| = {} s, og "
             "slingringen har perioden 4K(m)/λ = {} s, {} s i grensen for en liten helling. ")
             .in(language, far.component, std::floor(far.least_cosine * 1000) / 1000,
                 (least ? Phrase("least", "minst") : Phrase("greatest", "størst")).in(language),
                 short_number(std::acos(std::max(far.least_cosine, -1.0)) * in_degrees),
                 far.perpendicular, spin_period(solution), short_number(2 * flips.interval),
                 short_number(stable.period())) +
         repetition(solution, flips);
}

/// The motion of a body with two equal moments, or of one that turns about a fixed axis.
std::string without_flips(const Solution& solution) {
  const Language language = solution.scene().language;
  if (solution.body.omega().isZero()) {
    return Phrase("The body is at rest: X = Id at all times.",
                  "Legemet er i ro: X = Id til alle tider.")
        .in(language);
  }
  if (solution.exact->kind() == motion::ExactMotion::Kind::steady) {
    return Phrase(
               "ω is constant, and the body turns about an axis fixed in space: X(t) = exp(tω̂). "
               "All components are constants and sinusoids with the period 2π/|ω| = {} s.",
               "ω er konstant, og legemet roterer om en akse som er fast i rommet: X(t) = "
               "exp(tω̂). Alle komponentene er konstanter og sinuskurver med perioden 2π/|ω| = {} "
               "s.")
        .in(language, spin_period(solution));
  }
  return Phrase(
             "Two principal moments are equal. The axis of symmetry circles L at a constant "
             "angle, with the period 2πI₂/|L| = {} s, and the body turns about this axis at a "
             "constant rate.",
             "To av hovedtreghetsmomentene er like. Symmetriaksen kretser om L i en konstant "
             "vinkel, med perioden 2πI₂/|L| = {} s, og legemet roterer om denne aksen med "
             "konstant fart.")
      .in(language, short_number(2 * std::numbers::pi * solution.body.principal().moments[1] /
                                 solution.body.momentum().norm()));
}

/// The smallest and the largest tilt in degrees.
std::pair<std::string, std::string> range_of_tilt(const motion::Tilt& tilt,
                                                  const std::vector<motion::Sample>& samples) {
  std::vector<double> tilts;
  for (const motion::Sample& sample : samples) tilts.push_back(tilt.of(sample) * in_degrees);
  const auto [least, greatest] = std::ranges::minmax(tilts);
  return {short_number(least), short_number(greatest)};
}

/// "It turns over at 1.2, 3.4 s."
std::string flips_of_reference(const std::vector<double>& times, Language language) {
  constexpr std::size_t most = 6;
  if (times.empty()) {
    return Phrase("It does not turn over in this time.",
                  "Legemet snur ikke i løpet av denne tiden.")
        .in(language);
  }
  const std::vector<double> first(
      times.begin(), times.begin() + static_cast<std::ptrdiff_t>(std::min(times.size(), most)));
  return Phrase(
             "It turns over at {:.4g}{} s, as the component of m along the intermediate axis "
             "changes sign.",
             "Legemet snur ved {:.4g}{} s, idet komponenten av m langs den midterste aksen "
             "skifter fortegn.")
      .in(language, fmt::join(first, ", "), times.size() > most ? ", …" : "");
}

/// The motion of a body with a wheel or an energy loss, from its reference.
std::string with_interior(const Solution& solution) {
  const motion::FreeBody& body = solution.body;
  const Language language = solution.scene().language;
  if (body.momentum().isZero()) {
    return Phrase("L is 0: the body turns against its wheel at a constant rate.",
                  "L er 0: Legemet roterer mot svinghjulet sitt med konstant fart.")
        .in(language);
  }
  const std::vector<motion::Sample>& samples = solution.reference;
  const motion::Tilt tilt(body);
  const std::string axis = scene::axis_name(body.principal().axes, tilt.axis());
  if (body.energy_loss() > 0) {
    return Phrase(
               "L is constant in space, and the energy falls. The momentum in the body, m = XᵀL, "
               "therefore crosses the curves of constant energy on the sphere |m| = |L|, down to "
               "the least. The angle between L and the principal axis {} is {} degrees at first "
               "and {} degrees at the end.",
               "L er konstant i rommet, og energien avtar. Dreieimpulsen i legemet, m = XᵀL, "
               "krysser derfor kurvene med konstant energi på kulen |m| = |L|, ned til den minste. "
               "Vinkelen mellom L og hovedaksen {} er {} grader ved starten og {} grader ved "
               "slutten.")
        .in(language, axis, short_number(tilt.of(samples.front()) * in_degrees),
            short_number(tilt.of(samples.back()) * in_degrees));
  }
  const auto [least, greatest] = range_of_tilt(tilt, samples);
  return Phrase(
             "L is constant in space, and so is the energy. The momentum in the body, m = XᵀL, "
             "therefore moves along a curve of constant energy on the sphere |m| = |L|. The angle "
             "between L and the principal axis {} stays between {} and {} degrees. {}",
             "L er konstant i rommet, og det er energien også. Dreieimpulsen i legemet, m = XᵀL, "
             "følger derfor en kurve med konstant energi på kulen |m| = |L|. Vinkelen mellom L og "
             "hovedaksen {} holder seg mellom {} og {} grader. {}")
      .in(language, axis, least, greatest, flips_of_reference(solution.own.flip_times, language));
}

}  // namespace

std::string interpretation(const Solution& solution) {
  if (!solution.body.is_rigid()) return with_interior(solution);
  const auto flips = solution.flips();
  if (!flips) return without_flips(solution);
  if (solution.exact->kind() == motion::ExactMotion::Kind::separatrix) {
    return Phrase(
               "The motion is on the separatrix: as time passes, L tends to the intermediate "
               "axis, and the body to a steady rotation about it. It turns over at most once.",
               "Bevegelsen er på separatrisen: Etter hvert går L mot den midterste aksen, og "
               "legemet mot en jevn rotasjon om den. Det snur høyst én gang.")
        .in(solution.scene().language);
  }
  return flips->turns_over() ? turning_over(solution, *flips) : wobbling(solution, *flips);
}

}  // namespace twrench::report
